"""Runs MetaGCODE: gather, form, values (spec/metagcode.md §5, §10). A phase with faults is the last one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.expand._metagcode_form import line_faults, tie
from deburr.expand._metagcode_gather import Gathered, Gatherer
from deburr.expand._metagcode_run import Run
from deburr.expand._metagcode_values import values_of
from deburr.fault import Fault, Halt

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr_grammar.document import Document


def worth_running(document: Document) -> bool:
    """Whether a run may find anything: whether there is a directive or a variable."""
    return any("|" in chunk.text or chunk.marked for chunk in document.chunks())


def run(job: Job) -> Iterator[None]:
    """Expand the programs of a job, joined in order."""
    gatherer = Gatherer(job)
    yield from gatherer.gather()
    faults, form = list(gatherer.faults), list[Fault]()
    for reached in gatherer.reached:
        snippets = {include.row for include in reached.source.includes}
        for fault in line_faults(reached, job.ruleset):
            if fault is None:
                yield
            else:
                (faults if fault.line in snippets else form).append(fault)
    _refuse(job, faults, gatherer.alone)
    gathered = Gathered()
    yield from gatherer.flatten(gathered)
    for fault in tie(gathered):
        if fault is None:
            yield
        else:
            form.append(fault)
    _refuse(job, form, gatherer.alone)
    values, faults = values_of(job)
    _refuse(job, faults[:1], gatherer.alone)
    yield from Run(job, gathered, values, gatherer.alone).steps()


def _refuse(job: Job, faults: list[Fault], unsure: bool) -> None:
    """End the run if there are faults; all of them are reported."""
    if not faults:
        return
    *others, last = (fault._replace(input=fault.input or unsure) for fault in faults)
    for fault in others:
        job.meet(fault)
    raise Halt(last)
