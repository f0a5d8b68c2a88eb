"""Every example of an rs274 error page through the real interpreter: bad ones are refused, good ones run."""

from pathlib import Path

import pytest

from deburr.catalogue import rules_of
from deburr.finding import Severity
from deburr_grammar.dialects import by_name
from support.oracle import judged
from support.pages import Example, checked, examples

DIALECT = by_name("rs274")
RUNS_BY_LUCK = {
    "rs274.o-unclosed-0": "a true `if` needs no end to run; always an error here (spec/rs274.md §6)",
    "rs274.o-unclosed-1": "an inner block that is passed over needs none either",
    "rs274.o-unopened-1": "an `else` in a loop is passed over with it",
    "rs274.domain-1": "where the stand-alone interpreter stands, it never comes to the line",
    "rs274.named-unterminated-0": "`o<drill call` is passed over without a word: no call is made",
}
NEVER_RUN = {
    "rs274.sub-name-unsafe": "the interpreter would run what stands in the names",
    "rs274.limit": "the interpreter goes on for ever (spec/rs274.md §7)",
}


def errors(example: Example) -> list[int]:
    """The lines in which there is an error: with a warning a program may run."""
    found = checked(example, DIALECT)
    return sorted({each.place.line for each in found if each.severity is Severity.ERROR and not each.place.file})


EXAMPLES = [
    pytest.param(rule.name, example, id=f"{rule.name}-{number}")
    for rule in rules_of("rs274")
    if rule.severity is Severity.ERROR and rule.name not in NEVER_RUN
    for number, example in enumerate(examples(rule, DIALECT))
    if not (example.settings or example.machine)
    and f"{rule.name}-{number}" not in RUNS_BY_LUCK
    and (example.good or errors(example))
]


@pytest.mark.oracle
@pytest.mark.parametrize(("rule", "example"), EXAMPLES)
def test_interpreter_agrees(rule: str, example: Example, tmp_path: Path) -> None:
    lines = example.program.split("\n")
    if example.good:
        assert judged(example.program, tmp_path, example.files).accepted
        return
    for line in errors(example):
        # One fault at a time: the interpreter stops at the first.
        others = {row for row, _, _ in example.places} - {line}
        program = "\n".join("" if at in others else text for at, text in enumerate(lines))
        verdict = judged(program, tmp_path, example.files)
        assert not verdict.accepted, (program, verdict)


@pytest.mark.oracle
@pytest.mark.parametrize("name", RUNS_BY_LUCK)
def test_what_runs_by_luck_still_does(name: str, tmp_path: Path) -> None:
    rule, _, number = name.rpartition("-")
    page = next(each for each in rules_of("rs274") if each.name == rule)
    example = list(examples(page, DIALECT))[int(number)]
    bad = {row for row, _, _ in example.places}
    last = max(bad)
    program = "\n".join("" if at in bad - {last} else text for at, text in enumerate(example.program.split("\n")))
    assert judged(program, tmp_path).accepted
