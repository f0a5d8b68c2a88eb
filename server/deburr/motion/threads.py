"""The passes of G76, a thread cut on a lathe, as moves. Never reads a program.

The moves are those of LinuxCNC's interpreter: each pass begins and ends on the drive line moved in by
what is cut, is fed in at the compound angle, and is slower to come in and out where the thread has a taper.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from deburr.motion.path import Kind

_MOST = 10_000
"""Passes that are shown: more are a slip of J."""
Step = tuple[Kind, float, float]
"""A move to an X and a Z."""


@dataclass(frozen=True)
class Thread:
    """Words of G76 in mm: where it starts (X, Z), the Z of its end, and the rest by letter."""

    start: tuple[float, float]
    end: float
    peak: float
    """I: from the drive line to the crest; below 0 an outer thread."""
    first: float
    """J: depth of the first pass."""
    depth: float
    """K: depth of the thread."""
    degression: float = 1.0
    """R: 1 passes of the same depth, 2 of the same area."""
    angle: float = 0.0
    """Q: degrees of the compound slide."""
    springs: int = 0
    """H: passes more at the full depth."""
    taper: float = 0.0
    """E: how long the taper is."""
    tapered: int = 0
    """L: 1 the entry, 2 the exit, 3 both."""


def steps(thread: Thread) -> Iterator[Step]:
    """All moves of the cycle."""
    first, full = abs(thread.peak) + abs(thread.first), abs(thread.peak) + abs(thread.depth)
    depth, count = first, 1
    while depth < full and count < _MOST:
        yield from _pass(thread, depth, full)
        count += 1
        depth = first + abs(thread.first) * (count ** (1 / max(thread.degression, 1.0)) - 1)
    for _ in range(max(thread.springs, 0) + 1):
        yield from _pass(thread, full, full)
    yield Kind.RAPID, thread.start[0], thread.end


def _pass(thread: Thread, depth: float, full: float) -> Iterator[Step]:
    inward = 1.0 if thread.peak > 0 else -1.0
    back = thread.start[0] + inward * (depth - full)
    deep = thread.start[0] + inward * depth
    up = thread.end > thread.start[1]
    slope = math.tan(math.radians(-thread.angle if up else thread.angle))
    aside = (depth - abs(thread.peak)) * slope
    begin = thread.start[1] - aside
    end = thread.end + abs(thread.depth) * slope - aside
    crest = deep - inward * abs(thread.depth)
    taper = -thread.taper if up else thread.taper
    yield Kind.RAPID, back, begin
    if taper and thread.tapered & 1:
        yield Kind.THREAD, crest, begin
        yield Kind.THREAD, deep, begin - taper
    else:
        yield Kind.RAPID, deep, begin
    if taper and thread.tapered & 2:
        yield Kind.THREAD, deep, end + taper
        yield Kind.THREAD, crest, end
    else:
        yield Kind.THREAD, deep, end
    yield Kind.RAPID, back, end
