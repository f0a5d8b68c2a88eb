"""Faults of texts that a run may never come to, held back under `Inputs.reached_only`: what is reached stops the run, the rest is passed. Knows no language."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.fault import Fault, Frame, Halt
from deburr.finding import Finding, Severity
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document

_NOTHING: Mapping[int, list[Fault]] = {}


class Held:
    """The faults that are held, by their file and row. Empty: every run may go by it without a look."""

    def __init__(self) -> None:
        self._files: dict[str, dict[int, list[Fault]]] = {}

    def __bool__(self) -> bool:
        return bool(self._files)

    def hold(self, fault: Fault) -> None:
        """Keep a fault until its line is reached."""
        self._files.setdefault(fault.file, {}).setdefault(fault.line, []).append(fault)

    def in_file(self, file: str) -> Mapping[int, list[Fault]]:
        """The faults of a file by row."""
        return self._files.get(file, _NOTHING)

    def come(self, job: Job, file: str, row: int, frame: Frame | None, missing: str = "") -> None:
        """Stop at a line that has faults. Those of the kind ``missing`` are that something further down is not there: only what asks for it minds."""
        if found := [fault for fault in self.in_file(file).get(row, ()) if fault.kind != missing]:
            raise self.stop(job, found, frame)

    def stop(self, job: Job, found: Iterable[Fault], frame: Frame | None) -> Halt:
        """The end of a run that meets held faults; all but the last, which ends it, are reported before."""
        *others, last = (fault._replace(stack=frame or fault.stack) for fault in self.taken(found))
        for fault in others:
            job.meet(fault)
        return Halt(last)

    def taken(self, found: Iterable[Fault]) -> list[Fault]:
        """Faults that are held no more: the run has come to them."""
        known = list(found)
        for fault in known:
            self._files[fault.file][fault.line].remove(fault)
        return known

    def left(self) -> Iterator[Fault]:
        """What the run passed."""
        for rows in self._files.values():
            for faults in rows.values():
                yield from (fault._replace(passed=True) for fault in faults)


def errors(job: Job, file: str, document: Document) -> Generator[None, None, list[Finding]]:
    """What a check calls wrong in a text, found in steps. What it finds in other files is theirs."""
    analysis = Analysis(document, job.ruleset, file, job.host, inputs=job.inputs)
    found = yield from analysis.gathering()
    return [each for each in found if each.severity is Severity.ERROR and each.place.file == file]


def fault_of(finding: Finding) -> Fault:
    """A finding of a check as a run would meet it."""
    place = finding.place
    return Fault(
        finding.rule.partition(".")[2], place.file, place.line, Span(place.col, place.end_col), finding.message
    )
