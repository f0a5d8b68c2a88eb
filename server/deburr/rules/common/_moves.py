"""What is wrong with moves on a machine that is described: by rules of every dialect, of a language's own pages, too."""

from __future__ import annotations

import math
from itertools import pairwise, repeat
from typing import TYPE_CHECKING

from deburr.machine import AXES
from deburr.motion.arcs import extremes
from deburr.motion.path import Flag, Happening, Kind, Zeros
from deburr.rule import Report
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any

    from deburr.motion.path import Path

_NEAR = 1e-6
"""Millimetres by which a place may be beyond a limit: numbers are rounded."""
_CUTS = frozenset((Kind.FEED, Kind.ARC, Kind.THREAD))
_AXES = "XYZ"


def outside(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Moves that bring an axis beyond its limits: the machine's, so that the tool's length counts."""
    limits = machine["limits"]
    for (index, length), zeros in zip(_with_lengths(path), _zeros(path)):
        if path.kinds[index] == Kind.SHIFT:
            continue
        beyond = dict[str, str]()
        of_machine = bool(path.flags[index] & Flag.MACHINE)
        for axis, low, high, moves in _reached(path, index, length):
            least, most = limits.get(axis, (low, high))
            far = low if low < least - _NEAR else high if high > most + _NEAR else None
            if far is not None and moves and (of_machine or _known(path, index, axis)):
                unit = "degrees" if axis in "ABC" else "mm"
                whose = "" if beyond else "the machine's limits "
                beyond[axis] = f"{axis} {far:.6g} {unit}, outside of {whose}{least:g} to {most:g}"
        if beyond:
            what = "the arc reaches" if path.kinds[index] == Kind.ARC else "the move goes to"
            counted = _counted(zeros.system and not of_machine, zeros.tool if "Z" in beyond else 0)
            yield Report(Span(0, 0), f"{what} {', and '.join(beyond.values())}{counted}", path.flat[index])


def too_low(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Rapids that end below Z safe, or go sideways there. To rise straight out is right, and so is what a canned cycle does in its hole."""
    safe = machine["z-safe"]
    columns = zip(path.kinds, path.flags, path.z, _zeros(path))
    for index, (kind, flags, end, zeros) in enumerate(columns):
        if kind != Kind.RAPID or not _known(path, index, "Z"):
            continue
        start = path.before(index)[2] if index and _known(path, index - 1, "Z") else math.inf
        # Straight down in the hole of a cycle is right, and so is to rise straight out.
        straight = safe if flags & Flag.CYCLE or end >= start else end
        low = min(start, end) if flags & Flag.SIDEWAYS else straight
        if low < safe - _NEAR:
            turns = "turning" if flags & Flag.SPINDLE else "off"
            said = f"a rapid at Z {low:.6g} mm, below the safe Z of {safe:g} mm, with the spindle {turns}"
            said += _counted(zeros.system and not flags & Flag.MACHINE, 0)
            yield Report(Span(0, 0), said, path.flat[index])


def without_spindle(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """The first cut after each time that the spindle stopped turning."""
    silent = False
    for index, (kind, flags) in enumerate(zip(path.kinds, path.flags)):
        if kind not in _CUTS:
            continue
        off = not flags & Flag.SPINDLE
        if off and not silent and _goes(path, index):
            yield Report(Span(0, 0), "a cut while the spindle does not turn; M3 or M4 starts it", path.flat[index])
        silent = off and (silent or _goes(path, index))


def without_feed(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """The first cut of those that have no feed."""
    for index, (kind, feed) in enumerate(zip(path.kinds, path.feeds)):
        if kind in _CUTS and not feed > 0 and _goes(path, index):
            yield Report(
                Span(0, 0), "a cut without a feed; write an F word on this line or before it", path.flat[index]
            )
            return


def _goes(path: Path, index: int) -> bool:
    """Whether a move leads anywhere, with any axis."""
    if path.kinds[index] == Kind.ARC or path.before(index) != (path.x[index], path.y[index], path.z[index]):
        return True
    return any(column[index] != (column[index - 1] if index else 0.0) for column in path.beside.values())


def _known(path: Path, index: int, axis: str) -> bool:
    """Whether the program has said where an axis is behind a move, and on an arc before it."""
    bit = 1 << AXES.index(axis)
    before = path.unknown[index - 1] if index and path.kinds[index] == Kind.ARC else 0
    return not (path.unknown[index] | before) & bit


def _counted(system: bool, tool: int) -> str:
    """What of a place is only taken for zero, as the end of a message."""
    names = [*(["the work offset"] if system else []), *([f"the length of tool {tool}"] if tool else [])]
    verb = "count" if len(names) > 1 else "counts"
    return (
        f"; {' and '.join(names)} {verb} as 0, since nothing gives {'them' if len(names) > 1 else 'it'}"
        if names
        else ""
    )


def _zeros(path: Path) -> Iterator[Zeros]:
    """Of each move what counts as zero for it."""
    for now, then in pairwise((Zeros(0, False, 0), *path.zeros, Zeros(len(path), False, 0))):
        yield from repeat(now, then.at - now.at)


def _with_lengths(path: Path) -> Iterator[tuple[int, Sequence[float]]]:
    """Each move with the tool length that holds."""
    changes = [(event.at, path.lengths[round(event.value)]) for event in path.events if event.what is Happening.LENGTH]
    changes.append((len(path) + 1, ()))
    length: Sequence[float] = (0.0, 0.0, 0.0)
    following = iter(changes)
    at, after = next(following)
    for index in range(len(path)):
        while index >= at:
            length = after
            at, after = next(following)
        yield index, length


def _reached(path: Path, index: int, length: Sequence[float]) -> Iterator[tuple[str, float, float, bool]]:
    """How far each axis goes in a move: the least and the greatest place, and whether it moves for all that is known."""
    start, end = path.before(index), (path.x[index], path.y[index], path.z[index])
    arc = path.arc(index)
    lows, highs = extremes(arc) if arc is not None else (end, end)
    lost = path.unknown[index - 1] if index else -1
    if path.flags[index] & Flag.MACHINE:
        # Only the axes that it names go anywhere.
        lost = 0
    for at, (axis, low, high, offset) in enumerate(zip(_AXES, lows, highs, length)):
        yield axis, low + offset, high + offset, bool(lost >> at & 1) or not low == high == start[at]
    for axis, column in path.beside.items():
        before = column[index - 1] if index else 0.0
        yield axis, column[index], column[index], bool(lost >> AXES.index(axis) & 1) or column[index] != before
