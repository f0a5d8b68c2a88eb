"""The flat program that a control would execute, as work that can be left: the same text, to the byte, that `deburr expand` prints."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Kept, Program, SourceMap, drive, interpreter
from deburr.finding import Severity
from deburr.ran import before_a_run, merged, worded
from deburr.source import eol_of
from deburr_grammar.document import Document
from deburr_grammar.text import split_lines

if TYPE_CHECKING:
    from deburr.fault import Fault
    from deburr.finding import Finding
    from deburr.ide.view import View

PACE = 200
"""Executed steps between two moments at which a run can be left: a few milliseconds' worth."""


class Expanded(NamedTuple):
    """A flat program. ``truncated``: the budget ended it; without that, a program with errors has no text."""

    text: str
    source_map: SourceMap
    findings: tuple[Finding, ...]
    truncated: bool


def expanding(
    view: View, inputs: Inputs | None = None, budget: Budget | None = None, more: Sequence[View] = ()
) -> Generator[int, None, Expanded]:
    """Check a program, and those that are joined to it, and run them if they have no errors; yields how many lines were executed."""
    inputs, views = inputs or Inputs(), (view, *more)
    found: list[Finding] = []
    for each in views:
        with Analysis(each.document, each.ruleset, each.file, each.host, inputs=inputs) as analysis:
            found += yield from _counting(analysis.gathering())
    lines, source_map = Kept(), SourceMap()
    module = interpreter(view.dialect.name)
    found = before_a_run(found, view.dialect, inputs, len(views))
    if module is None or _wrong(found):
        return Expanded("", source_map, tuple(found), False)
    programs = [Program(each.file, each.document) for each in views]
    job = Job(programs, view.ruleset, view.host, lines, inputs, budget or Budget(), source_map, PACE)
    for _ in drive(job):
        yield job.steps
    met = [_finding(fault, views, job) for fault in job.faults]
    whole = job.cut or not _wrong(met)
    return Expanded(
        _joined(lines.lines, view.document.text, views[-1].document.text) if whole else "",
        source_map,
        tuple(merged(found, met)),
        job.cut,
    )


def instead(view: View, text: str) -> View:
    """The program with another text in its place: an older version of it, say."""
    given = view.dialect.given(view.ruleset.settings, view.host.read)
    return replace(view, document=Document.parse(text, view.dialect, given=given))


def _wrong(findings: Iterable[Finding]) -> bool:
    return any(finding.severity is Severity.ERROR for finding in findings)


def _counting(checking: Generator[None, None, list[Finding]]) -> Generator[int, None, list[Finding]]:
    """A check, in which nothing is executed."""
    while True:
        try:
            next(checking)
        except StopIteration as done:
            found: list[Finding] = done.value
            return found
        yield 0


def _joined(lines: list[str], first: str, last: str) -> str:
    """The lines with the ends that the first source has, the last one ended as the last source is."""
    eol = eol_of(first)
    return eol.join(lines) + (eol if lines and last.endswith(("\n", "\r")) else "")


def _finding(fault: Fault, views: Sequence[View], job: Job) -> Finding:
    """A fault as a finding; what ended the run is an error whatever its rule says."""
    view = next((each for each in views if each.file == fault.file), views[0])
    text = view.document.text if fault.file == view.file else view.host.read(fault.file) or ""
    lines = split_lines(text)
    found = worded(fault, view.ruleset, lines[fault.line] if fault.line < len(lines) else "")
    return found._replace(severity=Severity.ERROR) if job.halted and fault is job.faults[-1] else found
