"""Fixes that rules make of their own bad examples: what they write, that the finding is gone and no other comes, and that they come to an end."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import pytest

from deburr import source
from deburr.analysis import Analysis
from deburr.catalogue import rules_of
from deburr.check import opened
from deburr.expand import Budget, Program, expand, interpreter
from deburr.finding import Finding
from deburr.fix import Fix, applied, cures, fixes_of
from deburr.mend import mended
from deburr.rule import Rule
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from support.pages import Example, MemoryHost, checked, examples

RULES = [rule for name in NAMES for rule in rules_of(name) if not rule.input]
OWN = [rule for rule in RULES if rule.fix is not None]

REVEALED = {
    # What could not be read named something that is not there, or that nothing else names.
    "metagcode.directive-not-first": {"metagcode.file-missing", "metagcode.block-unclosed"},
    "metagcode.loop-var-literal": {"metagcode.loop-var-unused"},
    "metagcode.unknown-directive": {"metagcode.file-missing", "metagcode.block-unclosed"},
    "rs274.named-unterminated": {"rs274.sub-unknown"},
    "rs274.o-condition": {"rs274.read-before-set"},
    "rs274.o-extra-text": {"rs274.sub-unknown"},
    "rs274.o-mismatch": {"rs274.sub-uncalled"},
    "rs274.o-unclosed": {"rs274.sub-uncalled"},
    "rs274.o-unknown": {"rs274.sub-unknown"},
    "rs274.operator-outside-brackets": {"rs274.read-before-set"},
    "cgt.declare-duplicate": {"cgt.declare-unused"},
    "z32.field-unknown": {"z32.jump-target-missing", "z32.range-end-missing"},
}
"""What a fix brings to light on some page: true of the program before, and hidden by the fault."""


_COMMENT = re.compile(r"\([^()]*\)|;.*")


class Case:
    """A bad example, and what is said of it."""

    def __init__(self, example: Example, dialect: str, rule: Rule) -> None:
        self.example = example
        self.dialect = by_name(dialect)
        self.rule = rule
        self.source = source.read(example.program.encode())
        assert isinstance(self.source, source.Source)
        self.host = MemoryHost(example.files)
        self.ruleset = RuleSet(self.dialect, example.settings, self._selected)
        document = opened(self.source, self.dialect, self.ruleset, self.host)
        self.analysis = Analysis(document, self.ruleset, "", self.host)
        self.findings = checked(example, self.dialect, self._selected)

    def _selected(self, rule: Rule) -> bool:
        return rule.default or rule.name == self.rule.name

    def proven(self) -> list[tuple[Finding, Fix]]:
        """All fixes of the rule's findings that hold as far as lines decide."""
        mine = [each for each in self.findings if each.rule == self.rule.name]
        pairs = [(finding, fix) for finding in mine for fix in fixes_of(self.analysis, finding)]
        return [(finding, fix) for finding, fix in pairs if cures(self.analysis, finding, fix.edits)]

    def mended(self, fix: Fix) -> "Case":
        """The example behind a fix."""
        assert isinstance(self.source, source.Source)
        text = applied(self.analysis.document, fix.edits).text
        program = f"{self.source.lead}{text}{self.source.tail}"
        return Case(replace(self.example, program=program), self.dialect.name, self.rule)

    def flat(self) -> Sequence[str] | None:
        """The flat program without comments; None where a run finds a fault or does not end soon."""
        if interpreter(self.dialect.name) is None:
            return None
        document = self.analysis.document
        done = expand([Program("", document)], self.ruleset, self.host, None, Budget(10_000, 10_000))
        lines = [_COMMENT.sub("", line).strip() for line in done.lines]
        return None if done.faults or done.cut else [line for line in lines if line]


def cases(rule: Rule) -> list[Case]:
    dialect = rule.name.partition(".")[0]
    return [Case(each, dialect, rule) for each in examples(rule, by_name(dialect)) if not each.good]


@pytest.mark.parametrize("rule", RULES, ids=[rule.name for rule in RULES])
def test_a_fix_takes_its_finding_away_and_brings_no_other(rule: Rule) -> None:
    found = [(case, fix) for case in cases(rule) for _, fix in case.proven()]
    assert found or rule.fix is None
    for case, fix in found:
        before, after = (Counter(each.rule for each in one.findings) for one in (case, case.mended(fix)))
        assert after[rule.name] < before[rule.name], fix
        assert set(after - before) <= REVEALED.get(rule.name, set()), fix


@pytest.mark.parametrize("rule", OWN, ids=[rule.name for rule in OWN])
def test_fixes_come_to_an_end(rule: Rule) -> None:
    for case in cases(rule):
        rounds = 0
        while (found := case.proven()) and rounds < 20:
            case, rounds = case.mended(found[0][1]), rounds + 1
        assert not found


@pytest.mark.parametrize("rule", OWN, ids=[rule.name for rule in OWN])
def test_safe_fixes_leave_the_flat_program_as_it_is(rule: Rule) -> None:
    for case in cases(rule):
        for _, fix in case.proven():
            before, after = (case.flat(), case.mended(fix).flat()) if fix.safe else (None, None)
            assert before is None or after is None or before == after, fix


SAFE = {
    "allow-unused",
    "metagcode.file-case",
    "metagcode.loop-step-negative",
    "metagcode.type-odd",
    "rs274.mixed-precedence",
    "rs274.return-label",
    "rs274.smithy-comment",
    "cgt.exitc-outside-call",
    "cgt.word-case",
    "z32.advanced-empty-field",
    "z32.fcepp-spelling",
    "z32.html-entity",
    "z32.lower-case",
    "z32.number-digits",
}
"""Rules whose fixes are safe: what the control reads is the same, or can be nothing else."""


def test_which_rules_have_safe_fixes() -> None:
    found = {rule.name for rule in OWN for case in cases(rule) for _, fix in case.proven() if fix.safe}
    assert {name if name.partition(".")[2] != "allow-unused" else "allow-unused" for name in found} == SAFE


# Of each rule a line of its page, and what its fix must make of the lines around the finding.
MADE = [
    ("metagcode.alpha-number", "#IF1 9 greaterthan 10 a", "#IF1 9 greaterthan 10 n"),
    ("metagcode.block-mismatch", "#ENDIF2", "#ENDIF1"),
    ("metagcode.directive-not-first", "G0 X1 #FILE a.txt", "G0 X1\n#FILE a.txt"),
    ("metagcode.double-sign", "G1 Z-|Top| F100", "G1 Z|Top| F100"),
    ("metagcode.file-case", "#FILE mill/a.txt", "#FILE Mill/a.txt"),
    ("metagcode.file-missing", "#FILE drill", "#FILE drill.txt"),
    ("metagcode.if-operator", "#IF1 |a| = 1 n", "#IF1 |a| equalto 1 n"),
    ("metagcode.if-syntax", "#IF1 |a| equalto 1", "#IF1 |a| equalto 1 n"),
    ("metagcode.if-syntax", "#ENDIF1 |a|", "#ENDIF1"),
    ("metagcode.if-syntax", "#IF1|a| equalto 1 n", "#IF1 |a| equalto 1 n"),
    ("metagcode.if-type", "#IF1 |Peck| greaterthan n 5", "#IF1 |Peck| greaterthan 5 n"),
    ("metagcode.label-missing", "#LOOP 1 |z| 2 c", "#LOOP1 |z| 2 c"),
    ("metagcode.loop-step-negative", "#LOOP1 |z| -2 c", "#LOOP1 |z| 2 c"),
    ("metagcode.loop-step-type", "#LOOP1 |z| c 2", "#LOOP1 |z| 2 c"),
    ("metagcode.loop-var-literal", "#LOOP1 Z 2 c", "#LOOP1 |Z| 2 c"),
    ("metagcode.loop-var-twice", "#LOOP1 |z| 2 c |z| 1 r", "#LOOP1 |z| 2 c"),
    ("metagcode.not-numeric", "#LOOP1 |Depth| 2mm c", "#LOOP1 |Depth| 2 c"),
    ("metagcode.unknown-directive", "#FILE1 drill.txt", "#FILE drill.txt"),
    ("metagcode.unterminated-variable", "#IF1 |a equalto 1 n", "#IF1 |a| equalto 1 n"),
    ("rs274.atan-form", "#1=ATAN[1]/2", "#1=ATAN[1]/[2]"),
    ("rs274.axis-conflict", "G10 L2 P1 X0 G0", "G0\nG10 L2 P1 X0"),
    ("rs274.axis-no-motion", "G53 X0", "G53 G0 X0"),
    ("rs274.bad-character", "G0 X1,5", "G0 X1.5"),
    ("rs274.bad-character", "G0 Z−2.5", "G0 Z-2.5"),
    ("rs274.block-delete-position", "N5 /G0 X1", "/N5 G0 X1"),
    ("rs274.comment-nested", "G0 X1 (drill (first) hole)", "G0 X1 (drill [first] hole)"),
    ("rs274.comment-unclosed", "G0 X1 (approach", "G0 X1 (approach)"),
    ("rs274.compare-chained", "o1 if [0 LE #1 LT 5]", "o1 if [0 LE #1 AND #1 LT 5]"),
    ("rs274.expression-unclosed", "G0 X[[1+2]*3", "G0 X[[1+2]*3]"),
    ("rs274.function-bracket", "#1=[ABS -5]", "#1=[ABS[-5]]"),
    ("rs274.in-compensation", "G55", "G40\nG55"),
    ("rs274.line-number", "N5 N6 G0", "N5 G0"),
    ("rs274.m-count", "T1 M6 S100 M3 M8 M48 M0", "T1 M6 S100 M3 M8 M48\nM0"),
    ("rs274.message-suppressed", "o1 if [#1 EQ 1] (MSG,wrong side)", "o1 if [#1 EQ 1]\n(MSG,wrong side)"),
    ("rs274.mixed-precedence", "#1=[-2**2]", "#1=[[-2]**2]"),
    ("rs274.named-undefined", "G0 Z#<dept>", "G0 Z#<depth>"),
    ("rs274.named-unterminated", "#<depth=3", "#<depth>=3"),
    ("rs274.o-extra-text", "o1 if [1] G0 X1", "o1 if [1]\nG0 X1"),
    ("rs274.o-extra-text", "o<drill> call 5", "o<drill> call [5]"),
    ("rs274.o-mismatch", "o2 endif", "o1 endif"),
    ("rs274.o-unknown", "o1 wend", "o1 endwhile"),
    ("rs274.operator-outside-brackets", "#4=#1+2", "#4=[#1+2]"),
    ("rs274.operator-outside-brackets", "G0 X10 // first hole", "G0 X10 ; first hole"),
    ("rs274.operator-unknown", "G0 X[3*[2+1] Y2", "G0 X[3*[2+1]] Y2"),
    ("rs274.param-equal-missing", "#1[2+3]", "#1=[2+3]"),
    ("rs274.param-equal-missing", "#<deep>[2+3]", "#<deep>=[2+3]"),
    ("rs274.percent", "%part 7", "%\n(part 7)"),
    ("rs274.return-label", "  o<pocket> return", "  o<slot> return"),
    ("rs274.semicolon-active", "G0 X1 ; debug, x #5420", "G0 X1 (debug, x #5420)"),
    ("rs274.sign-chained", "G0 X--1", "G0 X-1"),
    ("rs274.sub-unknown", "o<dril> call [3]", "o<drill> call [3]"),
    ("rs274.value-missing", "G0 XO Y0", "G0 X0 Y0"),
    ("rs274.word-conflict", "G33 Z-5 K1 F100", "F100\nG33 Z-5 K1"),
    ("rs274.g-group", "G0 X1 G1 Y2 F100", "G0 X1\nG1 Y2 F100"),
    ("rs274.m-group", "M7 M8", "M8\nM7"),
    ("rs274.m-group", "M3 S100 M3", "M3 S100"),
    ("rs274.axis-conflict", "G92 X0 G1 Y5 F100", "G92 X0\nG1 Y5 F100"),
    ("rs274.word-repeated", "G0 X1 Y2 X1", "G0 X1 Y2"),
    ("cgt.bracket-no-word", "<G90>", "G90"),
    ("cgt.bracket-no-word", "<<X#XPOS>>", "<X#XPOS>"),
    ("cgt.bracket-unclosed", "<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS", "<#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS>"),
    ("cgt.call-in-text", "S#SPEED M03 #CALL(coolant)", "S#SPEED M03\n#CALL(coolant)"),
    ("cgt.command-syntax", "#UPDATE(#XPOS #YPOS)", "#UPDATE(#XPOS,#YPOS)"),
    ("cgt.command-syntax", "#EVAL(#V1=SQR(4) // root", "#EVAL(#V1=SQR(4)) // root"),
    ("cgt.declare-output", "#INT #passes #depth", "#INT #passes, #depth"),
    ("cgt.declare-unused", "#INT #passes, #depth", "#INT #depth"),
    ("cgt.else-misplaced", "<T#NTOOL>#ELSE <T0>", "<T#NTOOL>#ELSE<T0>"),
    ("cgt.if-comma", "#IF(#V2>3#OR#V2<-1)<M08>", "#IF(#V2>3,#OR#V2<-1)<M08>"),
    ("cgt.if-syntax", "#IF(#V1=>3)<M08>", "#IF(#V1>=3)<M08>"),
    ("cgt.if-string", "#IF(#S1>3)<M08>", "#IFSTR(#S1>3)<M08>"),
    ("cgt.section-name", "@ DWELL", "@DWELL"),
    ("cgt.space-outside", "<X#XPOS> <Y#YPOS>", "<X#XPOS>< Y#YPOS>"),
    ("cgt.word-case", "<X#XPOS#and Y#YPOS>", "<X#XPOS#AND Y#YPOS>"),
    ("cgt.word-unknown", "<X#XPSO>", "<X#XPOS>"),
    ("z32.advanced-empty-field", "!X=0;;Y=1!", "!X=0;Y=1!"),
    ("z32.advanced-mixed", "!HA=1! G0 X1", "!HA=1!\nG0 X1"),
    ("z32.advanced-unterminated", "N10 !HA=1;HB=2", "N10 !HA=1;HB=2!"),
    ("z32.alias-form", "G25 XYZ", "G25XYZ"),
    ("z32.angle-unclosed", "X<HA*2 Y5", "X<HA*2> Y5"),
    ("z32.falls-into-section", "G0 Z100", "G0 Z100\nM30"),
    ("z32.fcepp-spelling", "A=$FECPP('INIT_VAR_SYST')", "A=$FCEPP('INIT_VAR_SYST')"),
    ("z32.field-unreachable", "!IF HA>1; EB; HB=2! HA=0!", "!IF HA>1; EB! HA=0!"),
    ("z32.function-paren", "HA<SN 30>", "HA<SN(30)>"),
    ("z32.g-conflict", "G0 X1 G1 Y2", "G0 X1\nG1 Y2"),
    ("z32.html-entity", "!IF HA&gt10; HA=1!", "!IF HA>10; HA=1!"),
    ("z32.if-falls-through", "!IF HA>1; HA=1! HA=0!", "!IF HA>1; HA=1; EB! HA=0!"),
    ("z32.if-syntax", "!IF HA>1 HA=5!", "!IF HA>1; HA=5!"),
    ("z32.jump-target-missing", "!IF HA>1; GON11-N20! HA=2!", "!IF HA>1; GON20-N20! HA=2!"),
    ("z32.lower-case", "X<ha+1>", "X<HA+1>"),
    ("z32.number-digits", "X1234567.12345", "X1234567.12"),
    ("z32.number-digits", "X-0.1234567890", "X-0.123456789"),
    ("z32.number-digits", "!HA=100000.0000!", "!HA=100000.000!"),
    ("z32.paren-unclosed", "HA< HB + (HC+HD/2)/(SN(HE) >", "HA< HB + (HC+HD/2)/(SN(HE)) >"),
    ("z32.range-end-active", "N2 G0 X2", "G0 X2\nN2"),
    ("z32.word-syntax", "X=5", "!X=5!"),
]


@pytest.mark.parametrize(("name", "line", "made"), MADE, ids=[f"{name} {line}" for name, line, _ in MADE])
def test_what_a_fix_makes_of_its_line(name: str, line: str, made: str) -> None:
    rule = next(each for each in RULES if each.name == name)
    case, finding, fix = next(
        (case, finding, fix)
        for case in cases(rule)
        for finding in [each for each in case.findings if each.rule == name and each.place.file == ""]
        if case.analysis.document.line(finding.place.line) == line
        for fix in fixes_of(case.analysis, finding)
    )
    before = case.analysis.document.text.split("\n")
    after = applied(case.analysis.document, fix.edits).text.split("\n")
    at = finding.place.line
    assert after == [*before[:at], *made.split("\n"), *before[at + 1 :]]


# Lines of which only who wrote them knows what was meant, and lines that an operator may leave out: what all fixes together make of them.
TOGETHER = [
    ("rs274", "G0 G1 X1 F100", None),
    ("rs274", "G90 G91", None),
    ("rs274", "G54 G17 G55", None),
    ("rs274", "G0 X1 G91 G1 Y2", None),
    ("rs274", "G0 X1 G1 Y2 G90", None),
    ("rs274", "X1 G0 G1 Y2", None),
    ("rs274", "G0 X#1 #1=5 G1 Y#1", None),
    ("rs274", "M3 M4", None),
    ("rs274", "M3 S100 M5", None),
    ("rs274", "M48 M49", None),
    ("rs274", "M0 M30 S5", None),
    ("rs274", "G0 X1 Y2 X3", None),
    ("rs274", "F100 S500 F200", None),
    ("rs274", "G0 X1 I1", None),
    ("rs274", "G0 X1e2", None),
    ("rs274", "G92 G1 X0 F100", None),
    ("rs274", "T1 M6 M3 M8 M48 M1 S4000", None),
    ("rs274", "  /G0 X1 (there) G1 Y2 (cut)", "  /G0 X1 (there)\n  /G1 Y2 (cut)"),
    ("rs274", "N10 G0 X1 G1 X2 Y2", "N10 G0 X1\nG1 X2 Y2"),
    ("rs274", "G0 X1 G0 Y2", "G0 X1\nG0 Y2"),
    ("rs274", "G1 X1 G1", "G1 X1"),
    ("rs274", "/M7 M8", "/M8\n/M7"),
    ("rs274", "/M0 M30 (end)", "/M0\n/M30 (end)"),
    ("rs274", "M1 M30", "M1\nM30"),
    ("rs274", "G28 G0 Z10", "G0\nG28 Z10"),
    ("rs274", "G1 X5 G92 Y0", "G1 X5\nG92 Y0"),
    ("z32", "G0 G1 X1", None),
    ("z32", "G0 X1 G91 G1 Y2", None),
    ("z32", "/G0 X1 G1 Y2", "/G0 X1\n/G1 Y2"),
]


@pytest.mark.parametrize(("dialect", "line", "made"), TOGETHER, ids=[f"{name} {line}" for name, line, _ in TOGETHER])
def test_no_fix_chooses_between_words_of_which_one_was_meant(dialect: str, line: str, made: str | None) -> None:
    language = by_name(dialect)
    ruleset = RuleSet(language)
    head, tail = (
        ("(P)\n", "\nM30\n") if dialect == "z32" else ("G21 G90 G17 F100\n", "\n" if "M30" in line else "\nM2\n")
    )

    def look(document: Document) -> Analysis:
        return Analysis(document, ruleset, "", MemoryHost({}))

    document = Document.parse(f"{head}{line}{tail}", language)
    assert look(document).findings()
    found = mended(document, look, unsafe=True).document.text
    assert found == f"{head}{line if made is None else made}{tail}"


def test_the_missing_end_stands_where_the_indented_lines_end() -> None:
    rule = next(each for each in RULES if each.name == "rs274.o-unclosed")
    bad = Example(False, "G21 G90 G17\n#1=1\no1 if [#1]\n  G0 X1\n\n  G0 X2\nG0 X3\nM2\n", {}, {}, ())
    case = Case(bad, "rs274", rule)
    _, fix = case.proven()[0]
    text = applied(case.analysis.document, fix.edits).text
    assert text == "G21 G90 G17\n#1=1\no1 if [#1]\n  G0 X1\n\n  G0 X2\no1 endif\nG0 X3\nM2\n"


def test_the_missing_end_comes_before_the_program_s_end() -> None:
    rule = next(each for each in RULES if each.name == "rs274.o-unclosed")
    case = Case(Example(False, "G21 G90 G17\n#1=1\no1 if [#1]\nG0 X1\n\nM2\n", {}, {}, ()), "rs274", rule)
    _, fix = case.proven()[0]
    assert applied(case.analysis.document, fix.edits).text == "G21 G90 G17\n#1=1\no1 if [#1]\nG0 X1\no1 endif\n\nM2\n"


def test_one_name_of_a_comment_is_taken_out() -> None:
    rule = next(each for each in RULES if each.name == "rs274.allow-unused")
    case = Case(Example(False, "G0 X1 (deburr: allow rs274.limit, rs274.abort)\nM2\n", {}, {}, ()), "rs274", rule)
    found = [applied(case.analysis.document, fix.edits).line(0) for _, fix in case.proven()]
    assert found == ["G0 X1 (deburr: allow rs274.abort)", "G0 X1 (deburr: allow rs274.limit)"]


@pytest.mark.parametrize(
    ("name", "text", "made"),
    [
        ("z32.program-missing", "(P)\n!GOP9!\nM30\n:1\nG26\n", "(P)\n!GOP9!\nM30\n:1\nG26\n:9\nG26\n"),
        ("z32.program-missing", "(P)\n!GOP9!\nM30\n:1\nG26", "(P)\n!GOP9!\nM30\n:1\nG26\n:9\nG26\n"),
        ("z32.fcepp-position", "G0 X1\nA=$FCEPP('INIT_VAR_SYST')\nM30\n", "A=$FCEPP('INIT_VAR_SYST')\nG0 X1\nM30\n"),
        # Whoever jumps to N2 does not want what stands before it.
        ("z32.range-end-active", "!GON1-N2!\n!GON2!\nN1 G0 X1\nN2 G0 X2\nM30\n", None),
        # A whole part of ten digits cannot be rounded.
        ("z32.number-digits", "X1234567890.5\nM30\n", None),
    ],
)
def test_what_a_fix_makes_of_a_program(name: str, text: str, made: str | None) -> None:
    rule = next(each for each in RULES if each.name == name)
    case = Case(Example(False, text, {}, {}, ()), "z32", rule)
    assert [each.rule for each in case.findings].count(name) == 1
    found = [applied(case.analysis.document, fix.edits).text for _, fix in case.proven()]
    assert found == ([] if made is None else [made])
