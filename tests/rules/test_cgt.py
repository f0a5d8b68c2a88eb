"""What the rules say of whole templates: the reference's triggers in the frame, its examples, habits of real templates, limits."""

from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.check import check
from deburr.finding import Finding, Severity
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr_grammar import Edit, Pos
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("cgt")
RULESET = RuleSet(DIALECT)
EXAMPLES = sorted((Path(__file__).parents[2] / "examples" / "cgt").glob("*.cgt"))


def found(text: str) -> list[Finding]:
    return Analysis(Document.parse(text, DIALECT), RULESET, "", MemoryHost({})).findings()


def rules(lines: str) -> list[str]:
    """The rules that speak of lines in the frame, each as often as it does."""
    return [finding.rule.removeprefix("cgt.") for finding in found(DIALECT.frame.replace("{}", lines))]


@pytest.mark.parametrize(
    ("trigger", "rule"),
    [
        ("@LINE\nX#XPOS", "section-duplicate"),
        ("@9x", "section-name"),
        ("@nowhere", "section-unknown"),
        ("#CALL(nope)", "section-missing"),
        ("@a\n#CALL(a)\n@", "call-recursive"),
        ("G0 #CALL(a) M8\n@a", "call-in-text"),
        ("#EXITC", "exitc-outside-call"),
        ("#EXIT M8", "unreachable"),
        ("#IF(#V1>3)<#EXIT M8>", "unreachable"),
        ("<X#XPOS", "bracket-unclosed"),
        ("X#XPOS>", "bracket-unopened"),
        ("<G90>", "bracket-no-word"),
        ("<#EXC D#DOFF>", "bracket-exc-first"),
        ("< #CYCLE <X#XPOS>>", "motion-suppressed"),
        ("<X#XPOS> <Y#YPOS>", "space-outside"),
        ("#ELSE<T0>", "else-misplaced"),
        ("<T#NTOOL>x#ELSE<T0>", "else-misplaced"),
        ("<#AND X#XPOS>", "operator-misplaced"),
        ("#IF(#V1)<..>", "if-syntax"),
        ("#IF(#V1>3)", "if-syntax"),
        ("#IF(#V2>3#OR#V2<-1)<..>", "if-comma"),
        ("#IF(#S1>3)<..>", "if-string"),
        ("#IFCHG(3)<..>", "ifchg-argument"),
        ("#REPEAT(-1)<..>", "repeat-count"),
        ("#REPEAT(1.5)<..>", "repeat-count"),
        ("#REPEAT(3)", "repeat-body"),
        ("#NOPE", "word-unknown"),
        ("#CALL()", "command-syntax"),
        ("#TABLE(t)", "command-syntax"),
        ("#EVAL(#myX=1)", "word-undeclared"),
        ("#XPOSY", "word-abuts-text"),
        ("#xpos", "word-case"),
        ("#INT #a", "declare-outside"),
        ("@DECLARE\n#INT #a\n#DEC #a", "declare-duplicate"),
        ("@DECLARE\n#INT #XPOS", "declare-reserved"),
        ("@DECLARE\n#INT #a", "declare-unused"),
        ("@DECLARE\nG90", "declare-output"),
        ("#EVAL(#S1=" + "a" * 255 + ")", "string-length"),
        ("#EVAL(#V1)", "eval-syntax"),
        ("#EVAL(3=#V1)", "eval-target"),
        ("#EVAL(#DATE=1)", "eval-target"),
        ("#EVAL(#V1=M03)", "eval-type"),
        ("#EVAL(#V1=FOO(1))", "function-unknown"),
        ("#EVAL(#V1=MAX(1))", "function-arguments"),
        ("#EVAL(#V1=1/0)", "divide-by-zero"),
        ("#EVAL(#V1=SQR(-1))", "math"),
        ("T#JOS(x)", "jos-direct"),
        ("JOS(length)", "jos-direct"),
        ("#FMT(#XPOS, Q3.4)", "format"),
        ("#FMT(#XPOS,T4.0)", "format-no-fraction"),
        ("#TABLE(nope, 1)", "table-missing"),
        ("#TABLE(t, 9)\n@t\n0,a\n1,b\n2,c\n3,d", "table-index"),
        ("@MOV\nG00", "table-row"),
        ("@DCOMP\n0,G40\n1,G41 D#DOFF", "table-word"),
        ("#GETBLK(0)", "getblk-unset"),
    ],
)
def test_the_triggers_of_the_reference_give_their_rule_and_no_other(trigger: str, rule: str) -> None:
    assert rules(trigger) == [rule]


def test_labels_that_count_from_one_are_all_reported() -> None:
    assert rules("@DCOMP\n1,G40\n2,G41\n3,G42") == ["table-label"] * 3


def test_a_template_without_start_end_or_motion() -> None:
    assert [f.rule for f in found("@LINE\nG01\n@\n")] == ["cgt.motion-section", "cgt.no-end", "cgt.no-start"]
    assert [f.rule for f in found("\n  notes\n")] == ["cgt.no-end", "cgt.no-start"]
    assert found("") == []


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_the_examples_are_clean(path: Path) -> None:
    assert found(path.read_text(encoding="utf-8")) == []


def test_there_are_examples() -> None:
    assert len(EXAMPLES) >= 3 and (EXAMPLES[0].parent / "mill.cl").is_file()


DECLARED = """\
@DECLARE
#DEC #var1,#var2,#var3,#cut_power
#INT #upPower,#curstep,#start,#length
#STR #string,#tflags
#FMT(#cut_power,T5.0)
@
@PIERCE
#REPEAT(#upPower)
<
#EVAL(#cut_power=#cut_power*1.05)
S#cut_power
>
@
@SAMPLE
IN
#IF(#var2<#var3)<#EXITC>
TAIL
@
@FXD1
#CALL(PIERCE)
#CALL(SAMPLE)
#EVAL(#V1=#var1+TLEN(#curstep)+#length+#start)
#EVAL(#S1=#string)
#EVAL(#S2=#tflags)
"""


@pytest.mark.parametrize(
    ("line", "named"),
    [
        ("#EVAL(#V1=#V1-#U2)", []),
        ("#IF(#V1<#U2)<a>", []),
        ("#RESET(#XPOS)", []),
        ("#EVAL(#V1=TOTEL())", []),
        ("#EVAL(#V1=TLEN(#curstep))", []),
        ("#EVAL(#S1=STRSUB(#string, #start, #length))", []),
        ("#EVAL(#V1=STRLEN(#tflags))", []),
        ("<X#XPOS>", []),
        ("< #MOV#OR X#XPOS >", []),
        ("< #DCOMP#EXC D#DOFF >", []),
        ("< X#XPOS#AND Y#YPOS >", []),
        ("<T#NTOOL>#ELSE< T0>", []),
        ("< #CYCLE <X#XPOS>< Y#YPOS>>", ["motion-suppressed"] * 2),
        ("< #CYCLE <X#XPOS>>< Y#YPOS>", ["motion-suppressed"]),
        ("< #CYCLE <X#XPOS <Y#YPOS>>>", ["motion-suppressed"] * 2),
        ("<X#XPOS> <Y#YPOS>", ["space-outside"]),
        ("#IF(#V1>3)<output>#ELSE<output2>", []),
        ("#IFSTR(#S1=G00)<output>#ELSE<output2>", []),
        ("#IFCHG(#XPOS)<output>#ELSE<output2>", []),
        ("#IF(#V2>3,#OR#V2<-1)<OUT>#ELSE<IN>", []),
        ("#IF(#V9=1)<#EXIT>\nM08", []),
        ("#IF(#var1<#var2)<#CALL(SAMPLE)>\nAFTER", []),
        ("#IF(#var1<#var2)<#RESET(#XPOS,#YPOS)>#ELSE<#UPDATE(#XPOS,#YPOS)>", []),
        ("#IF(#var1<#var2,#AND#U2=1)<#RESET(#XPOS,#YPOS)>#ELSE<#UPDATE(#XPOS,#YPOS)>", []),
        ("#IF(#var1<#var2,#OR#U2=1)<#RESET(#XPOS,#YPOS)>#ELSE<#UPDATE(#XPOS,#YPOS)>", []),
        ("#TABLE(myTable, 2)\n@myTable\n0,Off\n1,Low\n2,Med\n3,High", []),
        ("THE VALUE OF V3=#V3", []),
    ],
)
def test_the_examples_of_the_reference_give_only_what_it_names(line: str, named: list[str]) -> None:
    assert rules(f"{line}\n@\n{DECLARED}") == named


def test_the_second_table_example() -> None:
    text = "@DECLARE\n#TBL#myTable\n@\n@START\n#EVAL(#myTable=3)\n#myTable\n@\n@myTable\n0,Off\n1,Low\n@\n@END\n"
    assert found(text) == []


REAL = """\
Heidenhain mill, written by hand
free header text #100 < and more

@START
BEGIN PGM #FILE MM   // header

#ONBLK
#EVAL(#V14=0)#EVAL(#FEED=100)
#CALL(TOOLCHG)
@TOOLCHG
// a comment line
TOOL CALL #TOOL Z S#SPEED
TOOL#TOOL#EVAL(#V1=jos(tool_dia))
#EVAL(#S10=jos(tool_desc))
#EVAL(#S9=M03)
#IF(#V1>0,#AND#V1<10)<#EVAL(#V2=1)#RESET(#XPOS,#YPOS)#EVAL(#ABSI=1)>

#IF(#S10>0)<D #S10>
@LINE
L< X#XPOS>< Y#YPOS>< Z#ZPOS>< F#FEED>
@END
M30
"""


def test_habits_of_real_templates_give_no_error() -> None:
    assert [finding.rule for finding in found(REAL)] == ["cgt.if-string"]
    assert all(finding.severity < Severity.ERROR for finding in found(REAL))


@pytest.mark.parametrize(
    ("inside", "outside", "rule"),
    [
        ("<#V1" * 32 + ">" * 32, "<#V1" * 33 + ">" * 33, "limit"),
        ("#REPEAT(100000)<a>", "#REPEAT(100001)<a>", "limit"),
        ("#REPEAT(0)<a>", "#REPEAT(-1)<a>", "repeat-count"),
        ("#EVAL(#S1=" + "a" * 254 + ")", "#EVAL(#S1=" + "a" * 255 + ")", "string-length"),
        ("#EVAL(#S1=" + "1" * 254 + ")", "#EVAL(#S1=" + "1" * 255 + ")", "string-length"),
        ("#TABLE(t,1)\n@t\n0,a\n1,b", "#TABLE(t,2)\n@t\n0,a\n1,b", "table-index"),
        ("#TABLE(t,0)\n@t\n0,a", "#TABLE(t,-1)\n@t\n0,a", "table-index"),
        ("#V99", "#V100", "word-abuts-text"),
        ("#S0", "@DECLARE\n#STR #S0", "declare-reserved"),
        ("#EVAL(#V1=SQR(0))", "#EVAL(#V1=SQR(-0.001))", "math"),
    ],
)
def test_both_sides_of_each_limit(inside: str, outside: str, rule: str) -> None:
    assert rules(inside) == []
    assert rules(outside) == [rule]


def test_a_duplicate_points_to_the_first() -> None:
    (finding,) = found(DIALECT.frame.replace("{}", "@RAP\nX#XPOS Y#YPOS Z#ZPOS"))
    assert [(related.place.line, related.place.end_col) for related in finding.related] == [(7, 4)]


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("#XPSO", "`#XPOS`"),
        ("#EVAL(#V1=SQRT(4))", "`SQR`"),
        ("#CALL(TOOLCHNG)", "`TOOLCHG`"),
        ("#FMT(#XPOS,d3.4)", "`D3.4`"),
        ("#EVAL(V1=3)", "`#V1`"),
        ("#EVAL(#V1=V2+1)", "`#V2`"),
        ("#EVEL(#V1=3)", "`#EVAL`"),
        ("#EXTI", "`#EXIT`"),
        ("#FMT(#F_Decimals,D3.4)", "`#F_Decimal`"),
        ("#FMT(#XPOS,D3,4)", "`D3.4`"),
        ("#IF(XPOS>3)<M08>", "`#XPOS`"),
        ("#IFSTR(S1=G00)<M08>", "`#S1`"),
        ("#RESET(XPOS)", "`#XPOS`"),
        ("#TABLE(tolchg,1)", "`TOOLCHG`"),
        ("@TOOLCHNG\nM06", "`TOOLCHG`"),
        ("@DECLARE\n#TBL#gear\n@DWELL\n#gear\n#TABLE(gears,0)\n@gears\n0,M41", "`gears`"),
        ("@DECLARE\n#CALCDEC#side\n@DWELL\n#side\n@$sides\n#RETNUM(1)", "`$sides`"),
    ],
)
def test_messages_offer_the_likely_name(line: str, hint: str) -> None:
    (finding,) = found(DIALECT.frame.replace("{}", line))
    assert f"did you mean {hint}?" in finding.message


@pytest.mark.parametrize(
    "lines",
    [
        "#CALL(a)\n@a\n#IF(#V1>1)<M08>#ELSE<\nM09\n>",
        "#REPEAT(#V1) // three times\n\n<\nM08\n>",
        "@DECLARE\n#CALCSTR #name\n@$name\n#IF(#V1>1)<#RETSTR(ONE)>\n#RETSTR(#S1)\n@DWELL\n#name",
        "@DECLARE\n#TBL#gear\n@gear\n0,M41\n@DWELL\n#EVAL(#gear=0)\n#gear",
        "#GETBLK(#V1)",
        "#EVMD(#anything=1)#EVMS(#text=M03)",
        "#IF(#V1>1)<#CALL(TOOLCHG)>#ELSE<M08>",
        "#EVAL(#S1=)",
        "#IFSTR(#S1=)<a>#ELSE<b>",
    ],
)
def test_what_is_right_is_not_called_wrong(lines: str) -> None:
    assert rules(lines) == []


@pytest.mark.parametrize(
    "lines",
    [
        "#EVAL(#V1=1",
        "#IF(#V1>3 <X#XPOS>",
        "#DEC #b,",
        "<X#XPOS #EVAL(#V1)>",
        "#IF(#V1)<a>#ELSE<b>",
        "@DECLARE\n#INT #n,\n@DWELL\n#n",
        "#IF (#V1>3)<a>",
        "#IF#V1>3)<a>",
        "#IF(#V1>3)a>",
        "#IF(#V1>3) <a>#ELSE<b>",
        "#IF(#V1>3)\n<\na\n>",
        "#IFF(#V1>3)<a>#ELSE<b>",
        "#IFSTRING(#S1=G00)<a>",
        "#REPAET(3)<M08>",
        "<X#XPOS>#ESLE<a>",
        "<X#XPOS#AND #EVAL(#V1)>",
        "#CALL TOOLCHG <X#XPOS>",
    ],
)
def test_a_syntax_fault_brings_no_other_finding_with_it(lines: str) -> None:
    assert len(rules(lines)) == 1


def test_very_deep_brackets_are_refused_and_not_walked() -> None:
    text = DIALECT.frame.replace("{}", "<#V1\n" * 3000)
    assert {finding.rule for finding in found(text)} == {"cgt.bracket-unclosed", "cgt.limit"}


@pytest.mark.parametrize(
    ("line", "columns"),
    [
        ("<X#XPOS#AND>", [(7, 11)]),
        ("<X#XPOS#AND Y#YPOS>", []),
        ("<#MOV#AND#OR X#XPOS>", [(5, 9)]),
        ("<#DCOMP#EXC D#DOFF>", []),
        ("<#DCOMP#EXC>", [(7, 11)]),
        ("<#DCOMP#EXC D#DOFF#AND S#SPEED>", [(18, 22)]),
        ("<#DCOMP#EXC D#DOFF#AND>", [(18, 22)]),
        ("<#AND X#XPOS#OR>", [(1, 5), (12, 15)]),
        ("<X#XPOS#AND<S#SPEED>>", [(7, 11)]),
    ],
)
def test_operators_that_join_nothing(line: str, columns: list[tuple[int, int]]) -> None:
    findings = found(DIALECT.frame.replace("{}", line))
    assert [finding.rule for finding in findings] == ["cgt.operator-misplaced"] * len(columns)
    assert [(finding.place.col, finding.place.end_col) for finding in findings] == columns


def with_machine(text: str, machine: str) -> list[str]:
    files = MemoryHost({"mill.toml": machine})
    findings = check(
        Source(DIALECT.frame.replace("{}", text)), DIALECT, RuleSet(DIALECT, {"machine": "mill.toml"}), "", files
    )
    return [f"{finding.place.file}:{finding.rule.removeprefix('cgt.')}" for finding in findings]


def test_a_table_word_of_the_machine_file_makes_a_section_a_table() -> None:
    rows = "#GEAR\n@GEAR\n0,M41 <low\n1,M42\n"
    assert with_machine(rows, '[words]\nGEAR = "table"') == []
    assert with_machine(rows + "3", '[words]\nGEAR = "table"') == [":table-row"]
    assert with_machine("#GEAR", '[words]\nGEAR = "table"') == [":table-missing"]
    assert with_machine("#GEAR", '[words]\nGEAR = "table"\n[tables]\nGEAR = ["M41"]') == []
    assert with_machine("@LINES\n#LINE\n", '[words]\nLINE = "table"\n') == [":section-unknown", ":table-missing"]


def test_an_edit_keeps_what_the_machine_file_says() -> None:
    text = "@START\n@END\n@GEAR\n0,M41\n"
    document = Document.parse(text, DIALECT, given=frozenset({"GEAR"}))
    edited = document.edit(Edit(Pos(4, 0), Pos(4, 0), "1,M42 <\n"))
    assert [edited.node(line).reading.name for line in (3, 4)] == ["table", "table"]
    assert document.node(3).reading.name == "table"
    assert Document.parse(text, DIALECT).node(3).reading.name == "template"


def test_a_faulty_machine_file_brings_no_other_finding_with_it() -> None:
    for machine in ("[words", "words = 1", '[word]\nWPOS = "decimal"', '[words]\nWPOS = "decimla"'):
        assert with_machine("W#WPOS", machine) == ["mill.toml:machine-file"]
    assert with_machine("W#WPOS", '[words]\nWPSO = "decimal"') == [":word-unknown"]
    assert with_machine("#MOV", '[tables]\nMOVE = ["G0"]') == ["mill.toml:machine-file"]
    assert with_machine("#MOV#TABLE(MOVE,0)", '[tables]\nMOVE = ["G0"]') == []


def test_a_machine_file_makes_words_known() -> None:
    ruleset = RuleSet(DIALECT, {"machine": "mill.toml"})
    document = Document.parse(DIALECT.frame.replace("{}", "W#WPOS #CODES"), DIALECT)
    for text, expected in (('[words]\nWPOS = "decimal"\n', 1), ("[words", 1), ("words = 1", 1)):
        host = MemoryHost({"mill.toml": text})
        assert len(Analysis(document, ruleset, "", host).findings()) == expected


@pytest.mark.parametrize(
    ("lines", "names"),
    [
        ("#EVAL(#V1=5)", ["#V1"]),
        ("#EVAL(#V1=5)\nX#V1", []),
        ("#EVAL(#V1=5)\n#REPEAT(#V1)<M08>", []),
        ("#EVAL(#V1=5)\n#FMT(#V1,D3.1)", ["#V1"]),
        ("#EVAL(#V1=#V2)\n#EVAL(#V2=#V1)", []),
        ("#EVAL(#V1=#V1+1)\n#EVAL(#V1=#V1+1)", ["#V1"]),
        ("#EVAL(#V1=5)\n#RESET(#V1)", []),
        ("#EVAL(#FEED=5)", []),
        ("#EVAL(#V1=5)\n#IF(#V1", []),
        ("#EVMD(#V1=5)\n#EVAL(#V1=6)", []),
    ],
)
def test_what_is_set_and_never_read(lines: str, names: list[str]) -> None:
    document = Document.parse(DIALECT.frame.replace("{}", lines), DIALECT)
    ruleset = RuleSet(DIALECT, selected=lambda rule: rule.name == "cgt.value-unread")
    findings = Analysis(document, ruleset, "", MemoryHost({})).findings()
    said = [document.line(each.place.line)[each.place.col : each.place.end_col] for each in findings]
    assert said == names
