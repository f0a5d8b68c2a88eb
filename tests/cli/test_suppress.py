"""`deburr: allow RULE` in comments."""

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr.suppress import Allow, in_line
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from deburr_grammar.text import Span

RS274 = by_name("rs274")
RULES = RuleSet(RS274)
ZERO = "rs274.divide-by-zero"


def check_allows(program: str, expected: list[tuple[str, int]], ruleset: RuleSet = RULES, size: int = 16_384) -> None:
    text = f"G21 G90 G17\n{program}\nF100\nM2\n"
    analysis = Analysis(Document.parse(text, RS274, size), ruleset)
    found = analysis.findings()
    assert [(finding.rule.removeprefix("rs274."), finding.place.line) for finding in found] == expected
    alone = [finding for line in range(text.count("\n")) for finding in analysis.line_findings(line)]
    whole = {rule.name for rule in ruleset.on_whole}
    assert alone == [finding for finding in found if "allow" not in finding.rule and finding.rule not in whole]


@pytest.mark.parametrize(
    "program",
    [
        f"G0 X[1/0] (deburr: allow {ZERO})",
        f"G0 X[1/0] (deburr: allow {ZERO} -- it never comes here)",
        f"G0 X[1/0] ; deburr: allow {ZERO}",
        f"(deburr: allow {ZERO})\nG0 X[1/0]",
        f"  ; deburr: allow {ZERO} -- why\nG0 X[1/0]",
        "G0 X[1/0] (deburr: allow rs274)",
        "G0 X[1/0] (deburr: allow rs274.divide)",
        f"G0 X[1/0] Y[2/0] (drill, deburr:allow {ZERO})",
        f"(a) (deburr: allow {ZERO}) G0 X[1/0] (b)",
        f"G0 X[1/0] (c (d) e) (deburr: allow {ZERO}, rs274.comment-nested)",
        f"(deburr: allow {ZERO})\n(deburr: allow rs274.comment-nested)\nG0 X[1/0] (c (d) e)",
        f"(deburr: allow rs274.comment-nested)\nG0 X[1/0] (c (d) e) ; deburr: allow {ZERO}",
        "(deburr: allow rs274.o-unclosed)\no1 if [1]",
    ],
)
def test_allowed(program):
    check_allows(program, [])
    check_allows(program, [], size=3)


@pytest.mark.parametrize(
    ("program", "expected"),
    [
        (f"(deburr: allow {ZERO})\n\nG0 X[1/0]", [("allow-unused", 1), ("divide-by-zero", 3)]),
        (f"G0 X1 (deburr: allow {ZERO})\nG0 X[1/0]", [("allow-unused", 1), ("divide-by-zero", 2)]),
        (f"G0 X[1/0]\n(deburr: allow {ZERO})", [("divide-by-zero", 1), ("allow-unused", 2)]),
        ("G0 X[1/0] (deburr: allow rs274.divide-by)", []),
        ("G0 X[1/0] (deburr: allow rs274.divide-b)", [("divide-by-zero", 1), ("allow-unknown", 1)]),
        (f"G0 X[1/0] (deburr: allow {ZERO} because)", [("divide-by-zero", 1), ("allow-unknown", 1)]),
        (f"G0 X[1/0] (deburr: allow {ZERO}, rs274.percent)", [("allow-unused", 1)]),
        ("G0 X1 (deburr: allow rs274.allow-unused)", [("allow-unused", 1)]),
        ("G0 X1 (deburr: allow z32.percent)", [("allow-unknown", 1)]),
        ("G0 X1 (deburr: allow)", [("allow-unknown", 1)]),
        ("G0 X1 (deburr: allowed rs274.percent)", [("allow-misspelt", 1)]),
        (f"G0 X[1/0] (deburr: ignore {ZERO})", [("divide-by-zero", 1), ("allow-misspelt", 1)]),
        (f"G0 X[1/0] (deburr: noqa: {ZERO} -- it never comes here)", [("divide-by-zero", 1), ("allow-misspelt", 1)]),
        (f"G0 X[1/0] ; DEBURR: ALLOW {ZERO.upper()}", [("divide-by-zero", 1), ("allow-misspelt", 1)]),
        (f"G0 X[1/0] (Deburr allow {ZERO})", [("divide-by-zero", 1), ("allow-misspelt", 1)]),
        ("G0 X1 (deburr: alow rs274.percent, rs274.comment-nested)", [("allow-misspelt", 1)]),
        ("G0 X1 (deburr: disable rs274)", [("allow-misspelt", 1)]),
        (
            "(deburr: ignore the inner edges)\n(DEBURR: ALLOW 0.2 MM)\n(deburr: dialect=rs274)\n(deburr: for rs274 only)",
            [],
        ),
        ("(debur: ignore)\n(deburr: ignore)\n(DEBURR ALL EDGES, R0.2 MAX)\n(see deburr: www.rs274.org)", []),
        ("G0 X1 (deburr: allow -- rs274.percent)", [("allow-unknown", 1)]),
        (f"M2\n(deburr: allow {ZERO})", [("text-after-end", 3)]),
    ],
)
def test_not_allowed(program, expected):
    check_allows(program, expected)
    check_allows(program, expected, size=3)


def test_what_is_off_cannot_be_unused():
    off = RuleSet(RS274, selected=lambda rule: rule.default and rule.name != ZERO)
    check_allows(f"G0 X[1/0] (deburr: allow {ZERO})", [], off)
    check_allows("G0 X[1/0] (deburr: allow rs274.divide)", [], off)
    check_allows("G0 X1 (deburr: allow rs274.percent)", [("allow-unused", 1)], off)


@pytest.mark.parametrize("name", NAMES)
def test_every_dialects_comments_count(name):
    dialect = by_name(name)
    assert dialect.comments
    for opens, closes in dialect.comments:
        text = f"{opens} deburr: allow {name}.x, {name} -- why{closes}"
        at = len(opens) + len(" deburr: allow ")
        first = Span(at, at + len(name) + 2)
        assert in_line(text, dialect) == (
            Allow(f"{name}.x", first, True),
            Allow(name, Span(first.end + 2, first.end + 2 + len(name)), True),
        )
        assert not in_line(f"G0 X1 {text}", dialect)[0].alone
    assert in_line("deburr: allow x", dialect) == ()
    assert in_line("G0 X1", dialect) == ()


def test_a_comment_without_a_name():
    assert in_line("(deburr: allow -- why)", RS274) == (Allow("", Span(1, 14), True),)


def test_messages(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X1 (deburr: allow rs274.percent, nonsense)\nF100\nM2\n")
    assert shell.run("check", "--output-format", "concise").out == (
        "a.ngc:2:22: warning rs274.allow-unused [*] `rs274.percent` finds nothing here; the comment would hide the next fault, take the name out\n"
        "a.ngc:2:37: warning rs274.allow-unknown `nonsense` is no rule of this language; nothing is allowed by it\n"
        "Found 2 warnings in 1 file (1 checked)\n"
    )


def test_a_word_that_allows_nothing_is_named_with_the_one_that_does(shell):
    shell.write("a.ngc", "G21 G90 G17\nG0 X1 (deburr: ignore rs274.percent -- why)\nF100\nM2\n")
    assert shell.run("check", "--output-format", "concise").out.startswith(
        "a.ngc:2:8: warning rs274.allow-misspelt this allows nothing; did you mean `deburr: allow rs274.percent`?\n"
    )
