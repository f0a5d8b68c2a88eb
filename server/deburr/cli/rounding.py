"""What `--decimals` does to arcs in R form, told by the same run with all digits beside it. Near a half circle a digit less moves the centre by hundredths. Writes nothing."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand import Job, Kept, SourceMap, drive
from deburr.expand.job import EXACT

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from deburr.fault import Fault
    from deburr.motion import Path

_REFUSED = "arc-radius"
_LEAST, _MOST = 0.001, 0.01
"""Millimetres: a centre that moves by less is where it was for any machine; of one that moves by more is always told."""
_RADIUS = re.compile(r"(?i)^[^;(]*(?:\([^)]*\)[^;(]*)*r")
"""A flat line that may have a radius."""


class Rounded(NamedTuple):
    """A run whose values were rounded, and its flat lines."""

    job: Job
    lines: Callable[[], Sequence[str]]


def said_of_rounding(run: Rounded, followed: Callable[[Sequence[str]], Path], shown: Callable[[str], str]) -> list[str]:
    """The first arc of a run that rounding makes another one, in words; nothing if there is none, or if the control has all digits.

    ``followed``: the path of flat lines on the machine that is configured; ``shown``: the name of a file.
    """
    job, decimals = run.job, run.job.inputs.decimals
    last = job.faults[-1] if job.halted else None
    if decimals is None or decimals >= EXACT or (last is not None and last.kind != _REFUSED):
        return []
    exact, source_map = Kept(), SourceMap()
    inputs = job.inputs._replace(decimals=EXACT)
    for _ in drive(Job(job.programs, job.ruleset, job.host, exact, inputs, job.budget, source_map)):
        pass
    if last is not None:
        return [_refusal(decimals, last, shown)] if len(exact.lines) > job.emitted else []
    if not any(map(_RADIUS.match, exact.lines)):
        return []
    allowed = min(max(2 * 10.0**-decimals, _LEAST), _MOST)
    found = _first(followed(exact.lines), followed(run.lines()), exact.lines, allowed)
    if found is None:
        return []
    flat, far = found
    file, row = source_map.origin(flat)[:2]
    return [
        f"{shown(file)}:{row + 1}: `--decimals {decimals}` moves the centre of this arc by {far:.3f} mm; more decimals keep it"
    ]


def _refusal(decimals: int, fault: Fault, shown: Callable[[str], str]) -> str:
    place = f"{shown(fault.file)}:{fault.line + 1}"
    return (
        f"{place}: it is `--decimals {decimals}` that makes this arc one that the control refuses; with more it is none"
    )


def _first(exact: Path, rounded: Path, lines: Sequence[str], allowed: float) -> tuple[int, float] | None:
    """The flat line of the first arc of a radius whose centre moves by more, and how far."""
    for at in range(min(len(exact), len(rounded))):
        one, two = exact.arc(at), rounded.arc(at)
        flat = exact.flat[at]
        if one is None or two is None or not _RADIUS.match(lines[flat]):
            continue
        far = math.dist(one.centre, two.centre)
        if far > allowed:
            return flat, far
    return None
