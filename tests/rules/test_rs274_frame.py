"""How RS274 programs are framed: percent signs, ends, line ends and what stands behind the end, by hand from spec/rs274.md §1."""

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding, Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document

DIALECT = by_name("rs274")
FRAME = ("percent", "program-end-missing", "text-after-end", "line-ends", "line-too-long")


def findings(program: str, size: int = 16_384, **severities: Severity) -> list[Finding]:
    """What the rules on frames say."""
    rules = RuleSet(
        DIALECT, None, lambda rule: rule.short in FRAME, {f"rs274.{name}": each for name, each in severities.items()}
    )
    return Analysis(Document.parse(program, DIALECT, size), rules).findings()


def said(program: str, size: int = 16_384) -> list[str]:
    found = findings(program, size)
    return [
        f"{each.place.line}:{each.place.col} {each.severity.word} {each.rule.removeprefix('rs274.')}" for each in found
    ]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("%\nG0 X1\n%", []),
        ("\n  \n%\nG0 X1\n%", []),
        ("%\nG0 X1\nM2", []),
        ("%\nG0 X1\nM2\n%", []),
        ("%\nG0 X1\nM2\n%\n%", []),
        ("G0 X1\nM2\n%", []),
        ("%\no1 if [#1]\nM30\no1 endif", []),
        ("%\nM#1", []),
        ("%\nM[1+1]", []),
        ("%\no9 call", []),
        ("%\n/M2", []),
        ("%\nG0 X1", ["0:0 error percent"]),
        ("  %\nG0 X1", ["0:2 error percent"]),
        ("%", ["0:0 error percent"]),
        ("%\no1 sub\nM2\no1 endsub\nG0 X1", ["0:0 error percent"]),
        ("%\no1 sub\nG0 X1\no1 endsub", ["0:0 info percent"]),
        ("G0 X1\n%", ["1:0 error percent"]),
        ("(x)\n%\nG0 X1\n%", ["1:0 error percent", "3:0 error percent"]),
        ("%part\nG0 X1\n%", ["0:1 error percent"]),
        ("%\nG0 X1\n% (end)", ["2:2 error percent"]),
        ("G0 X1 %\nM2", ["0:6 error percent"]),
    ],
)
def test_percent_signs(program: str, expected: list[str]) -> None:
    assert said(program) == expected
    assert said(program, 3) == expected


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("", []),
        ("\n \n", []),
        ("G0 X1\nM2\n", []),
        ("G0 X1\nM99\n", []),
        ("M98 P1\no1\nG0 X1\nM99", []),
        ("o1 do\nM2\no1 while [#1]", []),
        ("o1 sub\nM2\no1 endsub\no1 call", []),
        ("o1 sub\nM2\no1 endsub\no[#1] call", []),
        ("o1 sub\nG0 X1\nM2", []),
        ("G0 X1\n\n", ["0:0 error program-end-missing"]),
        ("(a)", ["0:0 error program-end-missing"]),
        ("o1 sub\nM2\no1 endsub\nG0 X1", ["3:0 error program-end-missing"]),
        ("o1 sub\nG0 X1\no1 endsub\no1 call", ["3:0 error program-end-missing"]),
        ("o1 sub\nG0 X1\no1 endsub\n(end)", ["3:0 info program-end-missing"]),
        ("o1 sub\nM2\no1 endsub", ["2:0 info program-end-missing"]),
    ],
)
def test_ends(program: str, expected: list[str]) -> None:
    assert said(program) == expected
    assert said(program, 3) == expected


def test_a_configured_severity_holds_for_files_of_subprograms_too() -> None:
    program = "o1 sub\nG0 X1\no1 endsub"
    assert [each.severity for each in findings(program)] == [Severity.INFO]
    configured = findings(program, **{"program-end-missing": Severity.WARNING})
    assert [each.severity for each in configured] == [Severity.WARNING]


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("M2\n\n(a) ; b\n%\n", []),
        ("M2\na\nb\n", ["1:0 info text-after-end"]),
        ("M2\na\no1 sub\no1 endsub\n  b\n", ["1:0 info text-after-end", "4:2 info text-after-end"]),
        ("%\n%\no1 sub\no1 endsub\n", ["2:0 info text-after-end"]),
    ],
)
def test_text_behind_the_end(program: str, expected: list[str]) -> None:
    assert said(program) == expected
    assert said(program, 3) == expected


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        ("G0 X1\r\nM2\r\n", []),
        ("G0 X1\r\r\nM2\n\r", []),
        ("\rG0 X1\nM2\r", []),
        ("G0 X1\rM2\r", ["0:0 error line-ends"]),
        ("G21\nG0 X1 \r \r X2\nM2\n", ["1:0 error line-ends"]),
    ],
)
def test_carriage_returns(program: str, expected: list[str]) -> None:
    assert said(program) == expected
    assert said(program, 3) == expected


@pytest.mark.parametrize(
    ("characters", "ending", "expected"),
    [(252, "\n", []), (253, "\n", ["0:252"]), (251, "\r\n", []), (252, "\r\n", ["0:251"]), (252, "", [])],
)
def test_a_line_end_of_two_characters_costs_one(characters: int, ending: str, expected: list[str]) -> None:
    program = "M2(" + "x" * (characters - 4) + ")" + ending
    assert [f"{each.place.line}:{each.place.col}" for each in findings(program)] == expected
