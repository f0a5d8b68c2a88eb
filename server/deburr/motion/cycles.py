"""Canned cycles as the moves that they stand for: G73, G81 to G89. Never decides where a hole is.

The order of moves is that of LinuxCNC's interpreter (spec/oracle.md §3), and so is what it holds
back when it goes down again in a hole.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.motion.path import Happening, Kind

if TYPE_CHECKING:
    from collections.abc import Iterator

BACK_OFF = 0.254
"""Millimetres (a hundredth of an inch) by which G73 goes up, and above which G83 stops when it goes down again."""
_MOST = 10_000
"""Pecks of one hole that are shown: more are a slip of Q."""
Step = tuple[Kind, tuple[float, float, float]] | tuple[Happening, float]
"""A move to a point along the first, the second and the drilled axis; or an event."""


class Levels(NamedTuple):
    """Along the drilled axis, in program coordinates: where the cycle goes down from, the bottom, and where it ends."""

    retract: float
    bottom: float
    clear: float


class Words(NamedTuple):
    """What the words of a cycle say: dwell in seconds, peck, and for G87 the way aside and the middle."""

    dwell: float = 0.0
    peck: float = 0.0
    aside: tuple[float, float] = (0.0, 0.0)
    middle: float = 0.0
    speed: float = 0.0
    """The spindle, as in `Happening.SPINDLE`."""


def hole(code: int, place: tuple[float, float], levels: Levels, words: Words) -> Iterator[Step]:
    """One hole, of ten times the code, from the retract level on."""
    bottom, clear = (*place, levels.bottom), (*place, levels.clear)
    match code:
        case 730 | 830:
            yield from _pecks(code, place, levels, words.peck)
        case 850:
            yield Kind.FEED, bottom
            yield Kind.FEED, (*place, levels.retract)
            yield Kind.RAPID, clear
        case 890:
            yield Kind.FEED, bottom
            yield Happening.DWELL, words.dwell
            yield Kind.FEED, clear
        case 860 | 880:
            yield Kind.FEED, bottom
            yield Happening.DWELL, words.dwell
            yield Happening.SPINDLE, 0.0
            if code == 880:
                yield Happening.STOP, 0.0
            else:
                yield Kind.RAPID, clear
            yield Happening.SPINDLE, words.speed
        case 870:
            yield from _back_bored(place, levels, words)
        case 840 | 740:
            yield Kind.THREAD, bottom
            yield Happening.SPINDLE, -words.speed
            yield Kind.THREAD, clear
            yield Happening.SPINDLE, words.speed
        case _:
            yield Kind.FEED, bottom
            if code == 820:
                yield Happening.DWELL, words.dwell
            yield Kind.RAPID, clear


def _pecks(code: int, place: tuple[float, float], levels: Levels, peck: float) -> Iterator[Step]:
    depth = levels.retract - peck
    for _ in range(_MOST if peck > 0 else 0):
        if depth <= levels.bottom:
            break
        yield Kind.FEED, (*place, depth)
        if code == 830:
            yield Kind.RAPID, (*place, levels.clear)
        yield Kind.RAPID, (*place, depth + BACK_OFF)
        depth -= peck
    yield Kind.FEED, (*place, levels.bottom)
    yield Kind.RAPID, (*place, levels.clear)


def _back_bored(place: tuple[float, float], levels: Levels, words: Words) -> Iterator[Step]:
    beside = (place[0] + words.aside[0], place[1] + words.aside[1])
    yield Kind.RAPID, (*beside, levels.retract)
    yield Happening.SPINDLE, 0.0
    yield Kind.RAPID, (*beside, levels.bottom)
    yield Kind.RAPID, (*place, levels.bottom)
    yield Happening.SPINDLE, words.speed
    yield Kind.FEED, (*place, words.middle)
    yield Kind.FEED, (*place, levels.bottom)
    yield Happening.SPINDLE, 0.0
    yield Kind.RAPID, (*beside, levels.bottom)
    yield Kind.RAPID, (*beside, levels.clear)
    yield Kind.RAPID, (*place, levels.clear)
    yield Happening.SPINDLE, words.speed
