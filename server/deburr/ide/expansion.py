"""The flat program that a control would execute, as work that can be left: the same text, to the byte, that `deburr expand` prints."""

from __future__ import annotations

from collections.abc import Generator, Iterable
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, SourceMap, drive, interpreter
from deburr.finding import Severity
from deburr.ran import before_a_run, merged, worded
from deburr.source import eol_of
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
    view: View, inputs: Inputs | None = None, budget: Budget | None = None
) -> Generator[None, None, Expanded]:
    """Check a program, and run it if it has no errors."""
    inputs = inputs or Inputs()
    found = yield from Analysis(view.document, view.ruleset, view.file, view.host, inputs=inputs).gathering()
    lines, source_map = _Lines(), SourceMap()
    module = interpreter(view.dialect.name)
    found = before_a_run(found, view.dialect)
    if module is None or _wrong(found):
        return Expanded("", source_map, tuple(found), False)
    programs = (Program(view.file, view.document),)
    job = Job(programs, view.ruleset, view.host, lines, inputs, budget or Budget(), source_map, PACE)
    yield from drive(job)
    met = [_finding(fault, view, job) for fault in job.faults]
    whole = job.cut or not _wrong(met)
    return Expanded(
        _joined(lines.lines, view.document.text) if whole else "", source_map, tuple(merged(found, met)), job.cut
    )


def _wrong(findings: Iterable[Finding]) -> bool:
    return any(finding.severity is Severity.ERROR for finding in findings)


def _joined(lines: list[str], source: str) -> str:
    eol = eol_of(source)
    return eol.join(lines) + (eol if lines and source.endswith(("\n", "\r")) else "")


def _finding(fault: Fault, view: View, job: Job) -> Finding:
    """A fault as a finding; what ended the run is an error whatever its rule says."""
    text = view.document.text if fault.file == view.file else view.host.read(fault.file) or ""
    lines = split_lines(text)
    found = worded(fault, view.ruleset, lines[fault.line] if fault.line < len(lines) else "")
    return found._replace(severity=Severity.ERROR) if job.halted and fault is job.faults[-1] else found


class _Lines:
    """Lines in memory."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.line = self.lines.append
