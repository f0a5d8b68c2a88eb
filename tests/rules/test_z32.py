"""The triggers of spec/z32.md §8 and the examples of §9, verbatim, and what several rules say of one line or program."""

from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.catalogue import rules_of
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

Z32 = by_name("z32")
EXAMPLES = Path(__file__).parents[2] / "examples" / "z32"


def found(
    program: str, files: dict[str, str] | None = None, file: str = "", **settings: object
) -> list[tuple[str, int, int, int]]:
    ruleset = RuleSet(Z32, {name.replace("_", "-"): value for name, value in settings.items()})
    findings = Analysis(Document.parse(program, Z32), ruleset, file, MemoryHost(files or {})).findings()
    return [(f.rule.removeprefix("z32."), f.place.line, f.place.col, f.place.end_col) for f in findings]


def check_marked(lines: str, *expected: str, **settings: object) -> None:
    """``lines`` in the frame; each expectation is `rule row marked-text`, the row counted from the first of ``lines``."""
    rows = lines.split("\n")
    said = [
        f"{rule} {row - 1} {rows[row - 1][start:end]}"
        for rule, row, start, end in found(Z32.frame.replace("{}", lines), **settings)
    ]
    assert said == list(expected)


TRIGGERS = [
    ("(oops", "comment-unclosed 0 (oops"),
    ("(a (b) c)", "comment-nested 0 (b)"),
    ("!X=0", "advanced-unterminated 0 !X=0"),
    ("!X=0;;Y=1!", "advanced-empty-field 0 ;;"),
    ("G0 X1 !HA=1!", "advanced-mixed 0 !HA=1!"),
    ("!G0 X1!", "advanced-movement 0 G0 X1"),
    ("!X10!", "advanced-movement 0 X10"),
    ("!FOO!", "field-unknown 0 FOO"),
    ("!GOP1;HA=2!", "field-unreachable 0 HA=2"),
    ("!IF HA; GON1!", "if-syntax 0 IF HA"),
    ("!IF HA>1!", "if-empty 0 IF HA>1"),
    ("!IF HA>1; HA=1! HA=0!", "if-falls-through 0 IF HA>1"),
    ("HA<X>Y>", "relational-outside-if 0 >"),
    ("!HA=X<Y!", "relational-outside-if 0 <"),
    ("X.", "number-format 0 ."),
    ("X1.2.3", "number-format 0 1.2.3"),
    ("X1 2", "number-format 0 1 2"),
    ("X1234567.12345", "number-digits 0 1234567.12345"),
    ("G<HA>", "g-expression 0 <HA>"),
    ("G0 G1 X1", "g-conflict 0 G0"),
    ("HA<X+1", "angle-unclosed 0 <X+1"),
    ("HA" + "<" * 21 + "1" + ">" * 21, "angle-depth 0 <1>"),
    ("HA<(X+1>", "paren-unclosed 0 (X+1"),
    ("HA<" + "(" * 11 + "1" + ")" * 11 + ">", "paren-depth 0 (1)"),
    ("HA<X+>", "expression-syntax 0 >"),
    ("HA<SQ(2)>", "function-unknown 0 SQ"),
    ("HA<SN 30>", "function-paren 0 SN"),
    ("HA<1/0>", "divide-by-zero 0 0"),
    ("HA<RQ(-1)>", "domain 0 RQ(-1)"),
    ("PAL[513]1", "index-range 0 513"),
    ("PAR[-1]1", "index-range 0 -1"),
    ("PAR[1.5]1", "index-not-integer 0 1.5"),
    ("PAL[256]1", "pal-read-only 0 PAL[256]"),
    ("PAL[1]2.5", "pal-rounded 0 2.5"),
    ("HA10 X<HA>", "same-block-use 0 HA"),
    ("!QQ=1!", "parameter-unknown 0 QQ"),
    ("!PI=3!", "parameter-reserved 0 PI"),
    ("!N=3!", "parameter-reserved 0 N"),
    ("G25UYZ", "axis-unknown 0 U"),
    ("!GON150!", "jump-target-missing 0 150"),
    ("!GON150!\nN150\nN150", "jump-target-duplicate 0 150"),
    ("!GON<HA>!", "jump-expression 0 <HA>"),
    ("!GON1-N2!\nN1", "range-end-missing 0 N2"),
    ("!GON1-N2!\nN1\nN2 X1", "range-end-active 2 N2"),
    ("!GON1-N2!\nN1\nN2 !HA=1!", "range-end-active 2 N2"),
    ("!GOP9!\n:1", "program-missing 0 9"),
    ("!GOP<1.5>!", "program-number 0 <1.5>"),
    ("!:L254-..\\X!", "file-outside 0 ..\\X"),
    ("G26", "g26-outside 0 G26"),
    ("AA1", "alias-unset 0 AA"),
    ("G25XX", "alias-form 0 G25XX"),
    ("G25XXY", "alias-form 0 G25XXY"),
    ("G25XZY", "alias-order 0 G25XZY"),
    ("X1\n$FCEPP('INIT_VAR_SYST')", "fcepp-position 1 $FCEPP('INIT_VAR_SYST')"),
    ("$FCEPP('X')", "fcepp-unknown 0 'X'"),
    ("$FECPP('INIT_VAR_SYST')", "fcepp-spelling 0 $FECPP"),
    ("M30\nX1", "text-after-end 1 X1"),
    ("HA&ltX+Y>", "html-entity 0 &lt"),
]


@pytest.mark.parametrize(("lines", "expected"), TRIGGERS)
def test_triggers(lines: str, expected: str) -> None:
    check_marked(lines, expected)


SET = {
    "jump-target-duplicate": "the trigger is two blocks N150, and a jump to them is what they are at fault for",
    "jump-first-line": "the frame's first line is a comment, so that no trigger stands there",
    "range-end-missing": "only the last block is meant to be missing; without N1 the jump has no target either",
    "range-end-active": "the trigger is a block N2 with words, as the end of a range",
    "range-open-at-end": "the trigger is a whole program whose range ends before its last block",
    "program-missing": "the control may hold program 9; only where the folder or the sections are known is it missing for certain",
    "file-missing": "the control may hold the file; only below a file root that can be listed is it missing for certain",
    "axis-unknown": "the trigger is any letter that the setting `axes` lacks; as an address it is a parameter, in G25 it must be an axis",
    "g26-missing": "the trigger is a program that something calls",
    "call-depth": "the trigger is a program that calls itself, or 33 that call each other",
    "fcepp-position": "the trigger is a block before the line",
    "text-after-end": "the trigger is a block behind M30",
    "label-unused": "it is off unless it is asked for",
}
"""Rules whose trigger of the table is none by itself, and why lines are set beside it."""

RUN = ("pal-machine-value", "read-before-set", "optional-state", "limit", "polar-origin")
"""Rules on which only a run can decide, or an input that was not given: those of the table, and the warning of §4 on CP."""

VERBATIM = [
    ("comment-unclosed", "(oops"), ("comment-nested", "(a (b) c)"), ("advanced-unterminated", "!X=0"), ("advanced-empty-field", "!X=0;;Y=1!"),
    ("advanced-mixed", "G0 X1 !HA=1!"), ("advanced-movement", "!G0 X1!"), ("advanced-movement", "!X10!"), ("field-unknown", "!FOO!"),
    ("field-unreachable", "!GOP1;HA=2!"), ("if-syntax", "!IF HA; GON1!"), ("if-empty", "!IF HA>1!"),
    ("if-falls-through", "!IF HA>1; HA=1! HA=0!"), ("relational-outside-if", "HA<X>Y>"), ("relational-outside-if", "!HA=X<Y!"),
    ("number-format", "X."), ("number-format", "X1.2.3"), ("number-format", "X1 2"), ("number-digits", "X1234567.12345"),
    ("g-expression", "G<HA>"), ("g-conflict", "G0 G1 X1"), ("angle-unclosed", "HA<X+1"), ("angle-depth", "HA" + "<" * 21 + "1" + ">" * 21),
    ("paren-unclosed", "HA<(X+1>"), ("paren-depth", "HA<" + "(" * 11 + "1" + ")" * 11 + ">"), ("expression-syntax", "HA<X+>"),
    ("function-unknown", "HA<SQ(2)>"), ("function-paren", "HA<SN 30>"), ("divide-by-zero", "HA<1/0>"), ("domain", "HA<RQ(-1)>"),
    ("index-range", "PAL[513]1"), ("index-range", "PAR[-1]1"), ("index-not-integer", "PAR[1.5]1"), ("pal-read-only", "PAL[256]1"),
    ("pal-rounded", "PAL[1]2.5"), ("same-block-use", "HA10 X<HA>"), ("parameter-unknown", "!QQ=1!"),
    ("parameter-reserved", "!PI=3!"), ("parameter-reserved", "!N=3!"), ("jump-target-missing", "!GON150!"), ("jump-expression", "!GON<HA>!"),
    ("program-number", "!GOP<1.5>!"), ("file-outside", "!:L254-..\\X!"), ("g26-outside", "G26"), ("alias-unset", "AA1"),
    ("alias-form", "G25XX"), ("alias-form", "G25XXY"), ("alias-order", "G25XZY"), ("fcepp-unknown", "$FCEPP('X')"),
    ("fcepp-spelling", "$FECPP('INIT_VAR_SYST')"), ("html-entity", "HA&ltX+Y>"),
]  # fmt: skip
"""Triggers of the table as they stand there."""


@pytest.mark.parametrize(("rule", "trigger"), VERBATIM)
def test_a_trigger_of_the_table_gives_its_rule_alone(rule: str, trigger: str) -> None:
    assert [(name, line) for name, line, *_ in found(Z32.frame.replace("{}", trigger))] == [(rule, 1)]


def test_each_rule_of_the_table_is_triggered_or_said_to_need_more() -> None:
    own = {rule.short for rule in rules_of("z32") if rule.module.startswith("deburr.rules.z32")}
    settled = {"word-syntax", "lower-case", "falls-into-section"}
    settled |= {"condition-constant", "loop-idle", "sub-unreachable", "cut-without-feed"}
    assert own - set(RUN) == {rule for rule, _ in VERBATIM} | set(SET) | settled
    assert not {rule for rule, _ in VERBATIM} & {*SET, *RUN}


@pytest.mark.parametrize("lines", ["X<HA>", "X<PAL[300]>", "/!HA=1!", "!GOP9!", "!:L254-NO\\FILE!", "N1\n!GON1!"])
def test_what_only_a_run_can_tell_is_left_to_it(lines: str) -> None:
    check_marked(lines)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("!GON10-N20!\nM30\nN10 X1\nM30\nN20", ["range-open-at-end 0 N20"]),
        ("!GON10-N20!\nM30\nN10 X1\nN20", []),
        ("!GON10-N20!\nM30\nN10 X1\n/M30\nN20", []),
        ("!GON10-N20!\nM30\nN10 X1\n!IF HA>1; GON20!\nM30\nN20", []),
        ("!GON10-N20!\nM30\nN10 X1\n!GON20!\nM30\nN20", []),
        ("!GON10-N20!\nM30\nN10 X1\n!GON10!\nN20", ["range-open-at-end 0 N20"]),
        ("!GON10-N20!\nM30\nN10 X1\n!GON<HA>!\nM30\nN20", ["jump-expression 3 <HA>"]),
        ("!GON10-N20!\nM30\nN10 X1\n!GON30-N40!\nM30\nN30\nN40\nN20", []),
        ("!GON10-N20!\nM30\nN10 X1\n!GON30-N40!\nN20\nM30\nN30\nN40", []),
        ("!GON10-N20!\nM30\nN10 X1\n!IF HA>1 GON20!\nM30\nN20", ["if-syntax 3 GON"]),
        ("N5\nN20\n!GON10-N20!\nM30\nN10 X1\n!GON5!", []),
        ("!GON10-N20!\n!GON30-N40!\nM30\nN10 X1\nN40\nM30\nN20\nM30\nN30 X1\n!GON40!", ["range-open-at-end 0 N20"]),
    ],
)  # fmt: skip
def test_ranges_that_never_return(lines: str, expected: list[str]) -> None:
    check_marked(lines, *expected)


@pytest.mark.parametrize(
    ("section", "expected"),
    [
        ("X1", ["g26-missing 3 X1"]),
        ("X1\nG26", []),
        ("X1\n/G26", ["g26-missing 4 /G26"]),
        ("X1\nM2", []),
        ("", ["g26-missing 2 :1"]),
        ("!IF HA>1; GON10!\nX1\nG26\nN10 X2", ["g26-missing 6 N10 X2"]),
        ("!IF HA>1; GON10!\nX1\nG26\nN10 X2\nG26", []),
        ("!GON10-N20!\nG26\nN10 X2\nN20", []),
        ("N10 X1\n!GON10!", []),
        ("N10 X1\n!IF HA>1; GON10!", ["g26-missing 4 !IF HA>1; GON10!"]),
        ("N10 X1\n!IF HA>1; GON10; EB! GON10!", []),
        ("!GOP3!", ["g26-missing 3 !GOP3!"]),
    ],
)
def test_sections_that_run_off_their_end(section: str, expected: list[str]) -> None:
    check_marked(f"!GOP1!\nM30\n:1\n{section}\n:2\nX5\n:3\nG26", *expected)


def test_a_subprogram_that_runs_off_its_end_is_said_at_its_first_call() -> None:
    files = {"cmos/1.z32": "X1\nG26\n", "cmos/2.z32": "X1\n", "cmos/more": ":3\nX1\n:4\nG26\n", "cmos-temp/2": "G26\n"}
    calls = "!GOP1!\n!GOP2!\n!GOP2!\n!GOP3!\n!GOP4!\n!GOS2!\n!GOP<HA>!\nM30\n"
    assert found(calls, files, cmos_dir="cmos") == [("g26-missing", 1, 4, 5), ("g26-missing", 3, 4, 5)]


def test_calls_are_counted_to_the_deepest() -> None:
    def nested(depth: int) -> str:
        sections = "".join(f":{n}\n!GOP{n + 1}!\nG26\n" for n in range(1, depth))
        return f"!GOP1!\nM30\n{sections}:{depth}\nG26\n"

    assert found(nested(32)) == []
    assert found(nested(33)) == [("call-depth", 96, 4, 6)]
    assert found(nested(40)) == [("call-depth", 96, 4, 6)]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("!GOP1!\nM30\n:1\n!GOP1!\nG26", ["call-depth 3 1"]),
        ("!GOP1!\nM30\n:1\n!IF HA>1; GOP1!\nG26", []),
        ("!GOP1!\nM30\n:1\n/!GOP1!\nG26", []),
        ("!GOP1!\nM30\n:1\n!IF HA>9; GON10!\n!GOP1!\nN10\nG26", []),
        ("!GOP1!\nM30\n:1\n!GOP2!\n!GOP1!\nG26\n:2\nM30", []),
        ("!GOP2!\nM30\n:1\n!GOP2!\nG26\n:2\n!HA=1; GOP1!\nG26", ["call-depth 3 2"]),
        ("!GOP1!\nM30\n:1\n!GOP<HA>!\nG26", []),
    ],
)
def test_programs_that_call_themselves(lines: str, expected: list[str]) -> None:
    check_marked(lines, *expected)


def test_a_file_that_calls_itself() -> None:
    files = {"root/A.z32": "!:L254-B!\nG26\n", "root/B.z32": "!:L254-A!\nG26\n"}
    assert found("!:L254-A!\nM30\n", files, file_root="root") == [("call-depth", 0, 7, 8)]


@pytest.mark.parametrize(
    ("lines", "way_out"),
    [
        ("!GON150!\nN15 X1", "did you mean N15?"),
        ("!GON150!\nN140 X1\nN160 X1\nN510 X1", "did you mean N510? the nearest are N140 and N160"),
        ("!GON150!\nN1500 X1\nN200 X1", "did you mean N1500? the nearest is N200"),
        ("!GON150!\nN10 X1\nN140 X1\nN155 X1\nN900", "the nearest are N140 and N155"),
        ("!GON150!\nN10 X1\nN140 X1", "the nearest is N140"),
        ("!GON150!", "no block has a number"),
        ("!GON1-N150!\nN1\nN145", "the nearest is N145"),
        ("!GOP4!\n:1\n:2", "there are 1, 2"),
        ("!AH=1!", "did you mean `HA`?"),
        ("!LY=1!", "did you mean `LX`?"),
        ("HA<SIN(30)>", "did you mean `SN`?"),
        ("$FCEP('SET_FILEROOT','A')", "did you mean `$FCEPP`?"),
        ("$FCEPP('SETFILEROOT','A')", "did you mean 'SET_FILEROOT'?"),
        ("FCEPP('SET_FILEROOT','A')", "did you mean `$FCEPP`?"),
        ("!GONE10!", "did you mean `GON`?"),
        ("!GOTO10!", "`GON` with its number"),
        ("!GOP N5!", "`GOP5`"),
        ("!HA:=5!", "`HA=5`"),
        ("!PALL[1]=5!", "did you mean `PAL[1]=5`?"),
        ("!PAR(1)=5!", "`PAR[1]=5`"),
        ("!L254-A\\B!", "`:L254-A\\B`"),
        ("HA=HB+1 ;next", "`!HA=HB+1!`"),
        ("!HA<HB+1>!", "`HA=HB+1`"),
    ],
)
def test_messages_name_what_may_be_meant(lines: str, way_out: str) -> None:
    ruleset = RuleSet(Z32)
    (finding,) = Analysis(Document.parse(Z32.frame.replace("{}", lines), Z32), ruleset).findings()
    assert way_out in finding.message


def test_files_are_suggested() -> None:
    files = {"root/SUBS/POCKET.z32": "G26\n", "root/DRILL": "G26\n"}
    program = "!:L254-SUBS\\POKET!\n!:L254-POCKET!\n!:L254-DRIL!\n!:L254-QQQ!\nM30\n"
    ruleset = RuleSet(Z32, {"file-root": "root"})
    said = [f.message for f in Analysis(Document.parse(program, Z32), ruleset, "", MemoryHost(files)).findings()]
    assert [message.partition("did you mean ")[2] for message in said] == [
        "`SUBS\\POCKET`?",
        "`SUBS\\POCKET`?",
        "`DRILL`?",
        "",
    ]


SOURCES = [
    "(this is a comment)", ":1", "N12 G0 Z120.5 ;some text", "!X=0!", "HA<X+Y>", "HA<X+Y*(2+X)>", "HA<X-Y>", "HA<X*Y>", "HA<X/Y>",
    "!X=Y! ;assignment", "!IF X=Y ; GOP1! ;equal operator", "!IF X<>Y ; X=X+1!", "!IF X<=Y ; X=X+1!", "!IF X<Y ; X=X+1!",
    "!IF X>=Y ; X=X+1!", "!IF X>Y ; X=X+1!", "HA<SN(X)>", "HA<CS(X)>", "HA<TAN(X)>", "HA<AT(X)>", "HA<ABS(X)>", "HA<INT(X)>", "HA<NEI(X)>",
    "!HX=1;HY=1;CP!", "!HR=1;HT=45;PC!", "HA<PI>\nX<HA>", "!IF HA>10; HA=1; EB! HA=0!", "!IF HA>10; GON20!\nN20",
    "!IF (HA+HB)*PAR[10]>=HC; GON20!\nN20", "!IF HA>10; IF HB<5; GON30!\nN30", "PAL[10+PAL[6]]<1+2>", "PAL[<2*PAL[1]>]5", "PAR[300]10",
    "X<Y>", "F<F+100>", "X<HA+1>", "!GOP1!", "!GOP<HA+1>!", "!GOS1!", "!GOS<HA+1>!", "!:L254-FOLDER\\FILE!",
    "G25XYZ\nAA1\nAB2\nAC3", "G25YZX\nAA1\nAB2\nAC3", "G25ZXY\nAA1\nAB2\nAC3",
    "N10 HA 10\nN20 HB 0.5\nN30 HC 30\nN40 G0 X<HA>\nN50 F<HB>\nN60 G1 X<HC+100>",
    "ADD_VAR=$FCEPP('SET_FILEROOT','C:\\TEST')", "A=$FCEPP('SET_FILEROOT','MYPATH',0)", "A=$FCEPP('ADD_VAR_SYST_SPEC','MYVARNAME',0)",
    "!GON150!\nN150 ; continue from here", "!IF HA>10; HA=1; EB! HA=0!\n(a) G0 X1 (b) ; c (d",
]  # fmt: skip


@pytest.mark.parametrize("lines", SOURCES)
def test_the_examples_of_the_reference_are_clean(lines: str) -> None:
    check_marked(lines)


def test_an_if_that_falls_through_is_an_info() -> None:
    check_marked("!IF HA>10; HA=1! HA=0!", "if-falls-through 0 IF HA>10")


JUMP = "%\nN10 G0 X1\n!GON150-N200!\nN151 G0 X2  ;3.\nN152 M30\nN150 G0 Z5  ;1.\nN200 ;2.\n"
LOOP = "%\nN1 G0 X0 Y0\n!HA=0!\nN10 G1 X<HA*10> F100\n!HA=HA+1;IF HA<3;GON10!\nN20 M30\n"


@pytest.mark.parametrize("program", [JUMP, LOOP])
def test_the_programs_of_the_reference_are_clean(program: str) -> None:
    assert found(program) == []
    assert found(program.replace("\n", "\r\n")) == []


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.z32")), ids=lambda path: path.stem)
def test_example_programs_are_clean(path: Path) -> None:
    assert found(path.read_text(encoding="utf-8")) == []


def test_there_are_example_programs() -> None:
    assert len(list(EXAMPLES.glob("*.z32"))) >= 3


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("PAL[0]1", []),
        ("PAL[255]1", []),
        ("PAL[256]1", ["pal-read-only 0 PAL[256]"]),
        ("PAL[255+1]1", ["pal-read-only 0 PAL[255+1]"]),
        ("PAL[512]1", ["pal-read-only 0 PAL[512]"]),
        ("PAL[513]1", ["index-range 0 513"]),
        ("PAL[-1]1", ["index-range 0 -1"]),
        ("X<PAL[512]>", []),
        ("X<PAL[513]>", ["index-range 0 513"]),
        ("PAR[512]1", []),
        ("PAR[513]1", ["index-range 0 513"]),
        ("PAL[512.5]1", ["index-not-integer 0 512.5"]),
        ("PAL[PAL[513]]1", ["index-range 0 513"]),
        ("X123456789", []),
        ("X1234567890", ["number-digits 0 1234567890"]),
        ("X000123456789", []),
        ("X1.23456789", []),
        ("X1.234567890", ["number-digits 0 1.234567890"]),
        ("X0.0000000001", []),
        ("HA" + "<" * 20 + "1" + ">" * 20, []),
        ("PAL[" + "<" * 19 + "PAL[<" + "<1>" + ">]" + ">" * 19 + "]5", ["angle-depth 0 <1>"]),
        ("HA<" + "(" * 10 + "1" + ")" * 10 + ">", []),
        ("HA<" + "SN(" * 11 + "1" + ")" * 11 + ">", ["paren-depth 0 SN(1)"]),
        ("HA<(1)+(1)+(1)+(1)+(1)+(1)+(1)+(1)+(1)+(1)+(1)+(1)>", []),
        ("G25XYZ AA1", []),
        ("AA1 G25XYZ", ["alias-unset 0 AA"]),
        ("PAL[1]2.0", []),
        ("PAL[1]<5/2>", ["pal-rounded 0 <5/2>"]),
        ("PAR[1]2.5", []),
        ("HA<HA+1>", []),
        ("G0 G00 X1", []),
        ("G1 G90", []),
    ],
)  # fmt: skip
def test_limits_on_both_sides(lines: str, expected: list[str]) -> None:
    check_marked(lines, *expected)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("G0 G1 X. Y<1/0> PAL[256]2.5", ["g-conflict 0 G0", "number-format 0 .", "divide-by-zero 0 0", "pal-read-only 0 PAL[256]", "pal-rounded 0 2.5"]),
        ("!QQ=1/0; X5; HA=RQ(-1)!", ["parameter-unknown 0 QQ", "divide-by-zero 0 0", "advanced-movement 0 X5", "domain 0 RQ(-1)"]),
        ("!HA=1/0", ["advanced-unterminated 0 !HA=1/0", "divide-by-zero 0 0"]),
        ("G0 X1 !HA=1/0;!", ["advanced-mixed 0 !HA=1/0;!", "divide-by-zero 0 0", "advanced-empty-field 0 ;!"]),
        ("X1 2 Y5+3", ["number-format 0 1 2", "number-format 0 +3"]),
        ("!IF HA>1; IF HB>1!", ["if-empty 0 IF HB>1"]),
    ],
)  # fmt: skip
def test_independent_faults_of_a_line_are_all_found(lines: str, expected: list[str]) -> None:
    check_marked(lines, *expected)


def test_block_numbers_compare_as_numbers() -> None:
    check_marked("!GON150.0!\nN0150 X1")
    check_marked("!GON<100+50>!\nN150 X1", "jump-expression 0 <100+50>")
    check_marked("!GON150!\nN150.5 X1", "jump-target-missing 0 150")


def test_block_numbers_of_other_sections_do_not_count() -> None:
    check_marked("!GON10!\nN10 X1\nM30\n:1\n!GON10!\nN10 X2")
    check_marked("!GON10!\nM30\n:1\nN10 X2\n:2\nN10 X3", "jump-target-duplicate 0 10")


def test_a_subprogram_may_end_in_g26_and_hold_an_m30() -> None:
    assert found("X<HA>\nG26\n") == []
    assert found("!IF PAR[1]>0; GON10!\nM30\nN10 X1\nG26\n") == []
    assert found("!IF PAR[1]<0; GON900!\nX1\nG26\nN900 M30\n") == []
    assert found("X1\nG26\nM30\n", file="jobs/cmos/7.z32", cmos_dir="cmos") == []
    assert found("X1\nG26\nM30\n", file="jobs/cmos-temp/7.z32", cmos_dir="cmos") == []
    assert found("X1\nG26\nM30\n", file="jobs/main.z32", cmos_dir="cmos") == [("g26-outside", 1, 0, 3)]


def test_an_alias_may_be_set_by_a_jump_a_caller_or_a_called_program() -> None:
    assert found("AA1\nG26\n") == []
    check_marked("!GOP<HA>!\nAA1")
    check_marked("!GON20!\nN10 AA1\nM30\nN20 G25XYZ\n!GON10!")
    check_marked("AA1 AB2 AA3\nAC4", "alias-unset 0 AA")


def test_text_behind_the_end_is_live_where_a_jump_or_a_call_reaches_it() -> None:
    check_marked("!GON<HA>!\nM30\nN10 X1", "jump-expression 0 <HA>")
    check_marked("/M30\nX1")
    check_marked("M30\n(only a comment)\n:1\nX1")
    check_marked("M2\nN10 X1", "text-after-end 1 N10 X1")


def test_programs_are_looked_for_in_the_folder_of_the_setting() -> None:
    files = {"cmos/1.z32": "G26\n", "cmos/more.z32": ":2\nG26\n:3\nG26\n", "cmos-temp/9": "G26\n"}
    calls = "!GOP1!\n!GOP2!\n!GOP3!\n!GOS9!\n!GOP9!\n!GOS1!\nM30\n"
    assert found(calls, files, cmos_dir="cmos") == [("program-missing", 4, 4, 5), ("program-missing", 5, 4, 5)]
    assert found(calls, {}, cmos_dir="cmos") == []
    assert found(calls, {f"jobs/{name}": text for name, text in files.items()}, "jobs/a.z32", cmos_dir="cmos") == [
        ("program-missing", 4, 4, 5),
        ("program-missing", 5, 4, 5),
    ]


def test_files_are_found_whatever_their_case_and_extension() -> None:
    files = {"root/Folder/File.z32": "G26\n"}
    assert found("!:L254-FOLDER\\FILE!\n!:L254-FOLDER/NONE!\nM30\n", files, file_root="root") == [
        ("file-missing", 1, 7, 18)
    ]


def test_nothing_is_said_of_a_title() -> None:
    assert found("TITLE (with (no) meaning\n!FOO!\n%\nX1\nM30\n") == []


def test_severities_are_those_of_the_reference() -> None:
    warnings = {
        "advanced-empty-field", "allow-unused", "field-unreachable", "if-empty", "g-conflict", "pal-rounded", "same-block-use", "parameter-unknown",
        "jump-first-line", "range-end-active", "range-open-at-end", "g26-missing", "fcepp-spelling", "html-entity",
        "polar-origin", "falls-into-section", "condition-constant", "loop-idle", "sub-unreachable", "cut-without-feed",
    }  # fmt: skip
    infos = {"if-falls-through", "jump-expression", "alias-order", "label-unused", "text-after-end", "lower-case"}
    own = {rule.short: rule for rule in rules_of("z32") if rule.module.startswith("deburr.rules.z32")}
    assert infos <= own.keys()
    for name, rule in own.items():
        expected = Severity.WARNING if name in warnings else Severity.INFO if name in infos else Severity.ERROR
        assert rule.severity is expected, name
    assert [name for name, rule in own.items() if not rule.default] == ["label-unused"]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("X1\n!GOP5!\n:5\nX2\nG26", ["falls-into-section 2 !GOP5!"]),
        ("X1\n!GOP5!\nX3\n\n(drill)\n:5 DRILL\nX2\nG26", ["falls-into-section 3 X3"]),
        ("X1\n!GOP5!\nM30\n:5\nX2\nG26", []),
        ("X1\n!GOP5!\n:5\nX2\nM30", []),
        ("X1\n!GOP5!\n!GON90!\n:5\nX2\nG26\n:6\nN90 M30", []),
        ("X1\n!GOP5!\n!IF PAR[1]>2; GON90!\n:5\nX2\nG26\n:6\nN90 M30", ["falls-into-section 3 !IF PAR[1]>2; GON90!"]),
        ("X1\n!GOP5!\n!IF PAR[1]>2; EB! GON90!\n:5\nX2\nG26\n:6\nN90 M30", ["falls-into-section 3 !IF PAR[1]>2; EB! GON90!"]),
        ("X1\n:1\nX2\n!GOP5!\n:5\nX2\nG26", ["falls-into-section 4 !GOP5!"]),
        (":5\nX2\nG26\n:6\n!GOP5!\nG26", []),
        ("X1\n!GOP5!\nG26\n:5\nX2\nG26", []),
        ("X1\n:5\nX2\nG26", []),
        ("X1\n!GOP<PAR[1]>!\n:5\nX2\nG26", []),
        ("X1\n!GOP5!\n!GON<PAR[1]>!\n:5\nX2\nG26", ["jump-expression 3 <PAR[1]>"]),
    ],
)  # fmt: skip
def test_a_main_part_that_runs_on_into_what_it_calls(program: str, expected: list[str]) -> None:
    text = f"(P)\n{program}\n"
    said = [f"{name} {line} {text.split(chr(10))[line][start:end]}" for name, line, start, end in found(text)]
    assert [each for each in said if "g26-outside" not in each] == expected
    assert [
        each for each in found(text, {"cmos/5.z32": "G26\n"}, cmos_dir="cmos") if each[0] == "falls-into-section"
    ] == []
