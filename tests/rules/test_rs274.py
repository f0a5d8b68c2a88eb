"""Every trigger of spec/rs274.md §8 that is in scope, as it stands there, in the smallest clean frame."""

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document

DIALECT = by_name("rs274")


def rules_said(block: str, **settings: str) -> list[str]:
    program = DIALECT.frame.replace("{}", block)
    findings = Analysis(Document.parse(program, DIALECT), RuleSet(DIALECT, settings)).findings()
    return [finding.rule.removeprefix("rs274.") for finding in findings]


TRIGGERS = {
    "comment-nested": ["(a (b) c)"],
    "comment-unclosed": ["G0 X1 (oops"],
    "bad-character": ["G0 X1 & Y2", "G0 X1 )"],
    "number-format": ["G0 X.", "G0 X1.2.3"],
    "value-missing": ["#1=", "S(speed)100"],
    "expression-unclosed": ["#1=[1+2"],
    "expression-syntax": ["#1=[1+]", "#1=[]", "#1=[*2]"],
    "operator-unknown": ["#1=[2^3]", "#1=[1 < 2]", "#1=[1 (x) + 2]"],
    "function-unknown": ["#1=FOO[1]", "#1=[NOT 1]"],
    "function-bracket": ["#1=SIN 30"],
    "atan-form": ["#1=ATAN[1]", "#1=ATAN[1]/2"],
    "operator-outside-brackets": ["#4=#1+2"],
    "divide-by-zero": ["#1=[5/0]"],
    "domain": ["#1=SQRT[-1]", "#1=LN[0]", "#1=ACOS[1.1]", "#1=[-8 ** 0.5]"],
    "not-finite": ["#1=EXP[1000]", "#1=[5 MOD 0]"],
    "integer-required": ["#1.5=3"],
    "param-range": ["#0=1", "#-1=3", "#5602=1"],
    "param-readonly": ["#5420=1", "#<_x>=3"],
    "param-equal-missing": ["#1 5"],
    "named-unterminated": ["#<foo=3"],
    "named-empty": ["#<>=3"],
    "exists-argument": ["#1=EXISTS[1]", "#1=EXISTS[#1]"],
    "line-number": ["N-5", "G0 N5", "N5 N6"],
    "block-delete-position": ["G0 /X1"],
    "percent": ["%abc", "%", "G0 %"],
    "text-after-end": ["M2\nG0 X1", "M30\nthank you"],
    "message-suppressed": ["(MSG,first)(second)", "(LOGCLOSE)(a)", "o1 if [1]\no1 endif (PRINT,a)"],
    "msg-spelling": ["( m s g , hi)", "(msg ,hi)", "(print ,hi)"],
    "semicolon-active": [";MSG,hi", "G0 X1 ; abort, no tool"],
    "python-comment": ["(PY,x)", "(PYRUN,f)", "(PYRELOAD)", ";py,x"],
    "mixed-precedence": ["#1=[0 AND 1 + 1]", "#1=[1 OR 0 AND 0]", "#1=[1 XOR 0 AND 0]", "#1=[-2**2]", "#1=[2**3**2]"],
    "compare-chained": ["#1=[3 GT 2 GT 1]"],
    "digits-joined": ["#1=[1 2]", "G0 X1 2", "#1 5=2"],
    "sign-chained": ["G0 X--1", "G0 X-+1", "#1=[1---2]"],
    "tan-pole": ["#1=TAN[90]", "#1=TAN[-90]"],
    "do-continue-break": ["o1 do\no1 continue\no1 break\no1 while [0]"],
    "repeat-fraction": ["o1 repeat [2.5]\no1 endrepeat", "o1 repeat [-0.5]\no1 endrepeat"],
    "return-label": ["o1 sub\no2 return\no1 endsub\no1 call"],
    "o-label-negative": ["o-1 if [1]\no-1 endif"],
    "o-extra-text": ["o1 if [1] G0 X1\no1 endif", "o1 call 5"],
    "o-unknown": ["o1 foo"],
    "o-condition": ["o1 if #1\no1 endif"],
    "o-label-integer": ["o1.5 if [1]\no1.5 endif"],
    "o-label-duplicate": ["o1 if [1]\no1 endif\no1 if [1]\no1 endif"],
    "o-unopened": ["o1 endif"],
    "o-mismatch": ["o1 do\no1 endwhile"],
    "o-unclosed": ["o1 if [1]"],
    "o-overlap": ["o1 if [1]\no2 if [1]\no1 endif\no2 endif"],
    "o-else-order": ["o1 if [1]\no1 else\no1 else\no1 endif"],
    "break-target": ["o1 repeat [2]\no1 break\no1 endrepeat"],
    "sub-nested": ["o1 sub\no2 sub\no2 endsub\no1 endsub"],
    "sub-redefined": ["o1 sub\no1 endsub\no1 sub\no1 endsub"],
    "named-undefined": ["G0 X#<nope>", "#<a>=2 G1 X#<a> F9"],
    "read-before-set": ["G0 X#77"],
    "set-twice": ["#3=15 #3=6"],
    "set-and-use": ["#3=6 G1 X#3 F9"],
    "sub-before-definition": ["o9 call\no9 sub\no9 endsub"],
    "sub-arguments": ["o1 sub\no1 endsub\no1 call " + "[1]" * 31],
    "sub-name-unsafe": ["o<$(date)> call"],
    "sub-uncalled": ["o1 sub\no1 endsub"],
    "sub-depth": ["o1 sub\no1 call\no1 endsub\no1 call"],
    "sub-outside": ["o1 endsub", "o1 return"],
}


@pytest.mark.parametrize(("rule", "block"), [(rule, block) for rule, blocks in TRIGGERS.items() for block in blocks])
def test_a_trigger_gives_its_rule_and_no_other(rule: str, block: str) -> None:
    assert set(rules_said(block)) == {rule}


def test_triggers_of_the_smithy_profile() -> None:
    assert rules_said("#5400=1", profile="smithy") == ["param-range"]
    assert rules_said("G0 X1 ;a", profile="smithy") == ["smithy-comment"]
    assert rules_said("M3 S1 $0", profile="smithy") == ["smithy-letter"]
    assert rules_said("M3 S1 $0 ;a") == []
    assert rules_said("N123456", profile="smithy") == ["line-number"]


@pytest.mark.parametrize(
    ("block", "rules"),
    [("#0=1", ["param-range"]), ("#1=1", []), ("#5601=1", []), ("#5602=1", ["param-range"])],
)
def test_parameters_run_from_1_to_5601(block: str, rules: list[str]) -> None:
    assert rules_said(block) == rules


@pytest.mark.parametrize(
    ("characters", "profile", "rules"),
    [
        (252, "linuxcnc", []),
        (253, "linuxcnc", ["line-too-long"]),
        (252, "smithy", []),
        (253, "smithy", ["line-long"]),
        (256, "smithy", ["line-long"]),
        (257, "smithy", ["line-too-long"]),
    ],
)
def test_lengths_of_lines(characters: int, profile: str, rules: list[str]) -> None:
    assert rules_said("(" + "x" * (characters - 2) + ")", profile=profile) == rules
