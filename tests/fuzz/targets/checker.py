"""The checker: whatever stands in a file, findings in places of it, fixes that can be made, and an end."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from deburr.analysis import Analysis
from deburr.check import check, opened
from deburr.finding import Finding
from deburr.fix import applied
from deburr.host import NoFiles
from deburr.mend import mended
from deburr.ran import ran
from deburr.ruleset import RuleSet
from deburr.source import NotAProgram, Source, read
from deburr_grammar.dialect import Dialect
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from fuzz.choices import Choices, joined
from fuzz.stock import numbered, programs
from support.places import check_finding, check_place

_REACH = {"limits": {"X": (-100, 300), "Z": (-20, 50)}, "z-safe": 5, "rapid": {"X": 1000}}
_FILE = "program"


@cache
def ruleset(dialect: Dialect, machine: bool) -> RuleSet:
    """All rules, with or without a machine whose reach they know."""
    return RuleSet(dialect, selected=lambda rule: True, machine=_REACH if machine else {})


def run(data: bytes) -> None:
    """A dialect, what else is done, and the bytes of the file."""
    choices = Choices(data)
    dialect, also = by_name(choices.pick(NAMES)), choices.byte()
    rules = ruleset(dialect, bool(also & 1))
    source = read(choices.rest())
    if isinstance(source, NotAProgram):
        assert source.reason
        return
    findings = check(source, dialect, rules, _FILE, run=_met if also & 2 else None, mend=bool(also & 4))
    for finding in findings:
        check_finding(finding, source.lines)
        for related in finding.related:
            check_place(related.place, source.lines)
    if also & 4:
        _fixes(source, dialect, rules, findings)
    if also & 8:
        _mends(source, dialect, rules)


def _met(analysis: Analysis) -> list[Finding]:
    return ran(analysis, blocks=2_000)


def _fixes(source: Source, dialect: Dialect, rules: RuleSet, findings: list[Finding]) -> None:
    """Each fix can be made, and changes the program."""
    document = opened(source._replace(text=source.lead + source.text), dialect, rules)
    for finding in findings:
        if finding.fix is not None:
            assert finding.fix.title
            assert applied(document, finding.fix.edits).text != document.text, finding


def _mends(source: Source, dialect: Dialect, rules: RuleSet) -> None:
    """All fixes together leave fewer findings, and say how many they took away."""

    def look(document: Document) -> Analysis:
        return Analysis(document, rules, _FILE, NoFiles(), tuple(source.notices()))

    document = opened(source, dialect, rules)
    done = mended(document, look, unsafe=True)
    before, after = len(look(document).findings()), len(look(done.document).findings())
    assert after < before if done.fixed else done.document.text == document.text


def seeds() -> Iterator[bytes]:
    """Each program, checked and mended."""
    for number, dialect in numbered():
        for at, program in enumerate(programs(dialect)):
            yield joined((number, at % 16), program)
