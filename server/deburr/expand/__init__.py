"""Runs programs to flat G-code: `expand`. Interpreters are modules named after their dialects and found by that name; none knows another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.expand.job import Budget, Job, Kept, Program
from deburr.expand.source_map import SourceMap
from deburr.fault import Fault, Halt
from deburr.inputs import Inputs

if TYPE_CHECKING:
    from types import ModuleType

    from deburr.host import Host
    from deburr.ruleset import RuleSet

__all__ = ["Budget", "Expansion", "Inputs", "Job", "Kept", "Program", "SourceMap", "drive", "expand", "interpreter"]


class Expansion(NamedTuple):
    """A flat program, where each line comes from, what the run met, and whether the budget cut it short."""

    lines: list[str]
    source_map: SourceMap
    faults: tuple[Fault, ...]
    cut: bool


def expand(
    programs: Sequence[Program],
    ruleset: RuleSet,
    host: Host,
    inputs: Inputs | None = None,
    budget: Budget | None = None,
) -> Expansion:
    """Run programs, joined in order, to the end. They must have passed `check` without an error, unless the inputs say `reached_only`."""
    kept, source_map = Kept(), SourceMap()
    job = Job(programs, ruleset, host, kept, inputs, budget, source_map)
    for _ in drive(job):
        pass
    return Expansion(kept.lines, source_map, tuple(job.faults), job.cut)


def drive(job: Job) -> Iterator[None]:
    """The run of a job in slices. What ends it stands last in the job's faults."""
    module = interpreter(job.ruleset.dialect.name)
    assert module is not None, "a dialect without an interpreter cannot be expanded"
    try:
        yield from module.run(job)
    except Halt as halt:
        job.halted = True
        job.meet(halt.fault)
    finally:
        job.dissolve()
    job.over()


def interpreter(dialect: str) -> ModuleType | Any:
    """The interpreter of a dialect; None if it has none.

    Its ``CHECKS`` says whether a run finds every error by itself, its ``ONLY_WHAT_RUNS`` that, besides,
    what is wrong with a line that never runs does not stop an expansion. ``FOLLOWS`` names what it heeds of
    `block_delete`, `machine_values`, `keep_n` and `decimals`. ``JOINS``: several programs run as one.
    ``unread(job)`` is what there is to say of values given by name where an error keeps a run from beginning.
    """
    name = f"{__name__}.{dialect}"
    return import_module(name) if find_spec(name) is not None else None
