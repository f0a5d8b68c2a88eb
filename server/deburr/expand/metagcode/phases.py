"""Runs MetaGCODE: gather, form, values (spec/metagcode.md §5, §10). A phase with faults is the last one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.expand.metagcode.build import Run
from deburr.expand.metagcode.form import CROSSES, line_faults, tie
from deburr.expand.metagcode.gather import Gathered, Gatherer
from deburr.expand.metagcode.unread import unread_names
from deburr.expand.metagcode.values import values_of
from deburr.fault import Fault, Halt

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document


def worth_running(document: Document) -> bool:
    """Whether a run may find anything: whether there is a directive or a variable."""
    return any("|" in chunk.text or chunk.marked for chunk in document.chunks())


def run(job: Job) -> Iterator[None]:
    """Expand the programs of a job, joined in order."""
    gatherer, gathered = Gatherer(job), Gathered()
    yield from gatherer.gather()
    on_lines, on_blocks = list[Fault](), list[Fault]()
    for reached in gatherer.reached:
        yield from _kept(line_faults(reached, job.ruleset), on_lines)
    _refuse(job, _in_gathering(gatherer, on_lines), gatherer.alone)
    yield from gatherer.flatten(gathered)
    yield from _kept(tie(gathered), on_blocks)
    if any(fault.kind == "unknown-directive" for fault in on_lines) and not job.inputs.reached_only:
        # It may be the end that is missing, misspelt: what blocks are meant is not known.
        on_blocks.clear()
    of_form = on_lines + [fault for fault in on_blocks if fault.kind != CROSSES]
    if job.inputs.reached_only:
        # `#FILE` is followed wherever it stands; all other lines only count where they are come to.
        for fault in of_form:
            job.held.hold(fault._replace(input=fault.input or gatherer.alone))
    elif of_form:
        job.unread += unread_names(job, gatherer.reached, on_lines)
        _refuse(job, of_form, gatherer.alone)
    for fault in on_blocks:
        if fault.kind == CROSSES or not job.inputs.reached_only:
            job.meet(fault)
    values, of_values = values_of(job)
    _refuse(job, of_values[:1], gatherer.alone)
    job.unread += unread_names(job, gatherer.reached, on_lines)
    yield from Run(job, gathered, values, gatherer.alone).steps()


def unread(job: Job) -> Iterator[str]:
    """What there is to say of values that were given by name where no run begins; nothing where not all of the texts could be gathered."""
    gatherer = Gatherer(job)
    for _ in gatherer.gather():
        pass
    found = (fault for reached in gatherer.reached for fault in line_faults(reached, job.ruleset))
    on_lines = [fault for fault in found if fault is not None]
    if not _in_gathering(gatherer, on_lines):
        yield from unread_names(job, gatherer.reached, on_lines)


def _in_gathering(gatherer: Gatherer, on_lines: list[Fault]) -> list[Fault]:
    """What keeps the text from being gathered: snippets that are not there, and lines that name none."""
    snippets = {(reached.file, each.row) for reached in gatherer.reached for each in reached.source.includes}
    return gatherer.faults + [fault for fault in on_lines if (fault.file, fault.line) in snippets]


def _kept(found: Iterator[Fault | None], faults: list[Fault]) -> Iterator[None]:
    """Keep what is found; a run may be left where that is nothing."""
    for fault in found:
        if fault is None:
            yield
        else:
            faults.append(fault)


def _refuse(job: Job, faults: list[Fault], unsure: bool) -> None:
    """End the run if there are faults; all of them are reported."""
    if not faults:
        return
    *others, last = (fault._replace(input=fault.input or unsure) for fault in faults)
    for fault in others:
        job.meet(fault)
    raise Halt(last)
