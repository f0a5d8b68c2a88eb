"""What is wrong with the form of a file before any line of it runs (spec/z32.md §11). Never looks at a value, a jump or a call."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from deburr.expand.lines import reports
from deburr.fault import Fault, Frame, Halt
from deburr.finding import Severity
from deburr.rule import Nodes, Rule, Syntax, Text
from deburr.ruleset import RuleSet
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.z32.unit import Unit

_WHEN_RUN = frozenset(
    (
        "divide-by-zero",
        "domain",
        "index-range",
        "index-not-integer",
        "pal-read-only",
        "program-number",
        "file-outside",
    )
)
"""Rules on lines that judge values and calls: what they say counts only where it is run."""


def faults(job: Job, unit: Unit, frame: Frame | None = None) -> Iterator[Fault | None]:
    """The faults in the form of a file's lines, in order; None now and then, where a run may be left.

    They are those that the rules on lines name, whether they are switched on or not: a line that
    they refuse cannot be run.
    """
    rules = _refusing(job.ruleset)
    for piece in unit.document.pieces():
        found = ((piece.line + index, rule, report) for index, rule, report in reports(piece, rules))
        for row, rule, report in sorted(found, key=lambda each: (each[0], each[2].span)):
            yield Fault(rule.short, unit.file, row, report.span, report.message, frame)
        yield None
    for row in unit.rows_with("config"):
        if row > unit.first_block:
            message = "`$FCEPP` sets up what the first block already runs with; move it before that block"
            yield Fault("fcepp-position", unit.file, row, Span(0, 0), message, frame)


def judge(job: Job, unit: Unit, frame: Frame | None) -> None:
    """End the run if a file that is called has such faults; all of them are reported."""
    refuse(job, [fault for fault in faults(job, unit, frame) if fault is not None])


def refuse(job: Job, found: list[Fault]) -> None:
    """End the run if there are faults, or hold them until it comes to their lines."""
    if job.inputs.reached_only:
        for fault in found:
            job.held.hold(fault)
    elif found:
        for fault in found[:-1]:
            job.meet(fault)
        raise Halt(found[-1])


@lru_cache(maxsize=8)
def _refusing(ruleset: RuleSet) -> RuleSet:
    """The rules on lines that say what cannot be run."""

    def refuses(rule: Rule) -> bool:
        on_lines = isinstance(rule.trigger, Syntax | Nodes | Text)
        return rule.severity is Severity.ERROR and on_lines and rule.short not in _WHEN_RUN

    return RuleSet(ruleset.dialect, ruleset.settings, refuses)
