"""How far a path reaches: the box around its moves, arcs with all that they swing out to."""

from __future__ import annotations

from math import hypot
from typing import TYPE_CHECKING, NamedTuple

from deburr.motion import Kind
from deburr.motion.arcs import extremes

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from deburr.motion import Path
    from deburr.motion.path import Point

_SLICE = 4_096
"""Moves between two moments at which the work can be left."""


class Extent(NamedTuple):
    """The lowest and the highest corner, in millimetres."""

    low: Point
    high: Point

    @property
    def size(self) -> float:
        """The way across, from corner to corner."""
        return hypot(*(high - low for low, high in zip(self.low, self.high)))


class Reach(NamedTuple):
    """The extent of all that is drawn, and of what is not rapid; None if that is nothing."""

    all: Extent | None = None
    cuts: Extent | None = None


def reach(path: Path) -> Reach:
    """How far a path goes."""
    return list(reaching(path))[-1]


def reaching(path: Path) -> Iterator[Reach]:
    """The same as work in slices: how far it goes up to there."""
    yield (found := Reach())
    for first in range(0, len(path), _SLICE):
        moves = range(first, min(len(path), first + _SLICE))
        seen = [index for index in moves if path.kinds[index] != Kind.SHIFT]
        cuts = [index for index in seen if path.kinds[index] != Kind.RAPID]
        found = Reach(_both(found.all, _around(path, seen)), _both(found.cuts, _around(path, cuts)))
        yield found


def _around(path: Path, moves: Sequence[int]) -> Extent | None:
    """The box around some moves."""
    if not moves:
        return None
    corners = [each for index in moves if (arc := path.arc(index)) is not None for each in extremes(arc)]
    low, high = [], []
    for axis, column in enumerate((path.x, path.y, path.z)):
        values = [column[index] for index in moves]
        # Where a move starts is where another ends, but that one may not be drawn.
        values += [column[index - 1] if index else path.start[axis] for index in moves]
        values += [corner[axis] for corner in corners]
        low.append(min(values))
        high.append(max(values))
    return Extent(_point(low), _point(high))


def _both(one: Extent | None, other: Extent | None) -> Extent | None:
    if one is None or other is None:
        return one or other
    return Extent(_point(list(map(min, one.low, other.low))), _point(list(map(max, one.high, other.high))))


def _point(values: Sequence[float]) -> Point:
    x, y, z = values
    return x, y, z
