"""What is drawn of a path: all of its moves, or, if they are too many, as many as tell the same to a stated tolerance."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING, NamedTuple

from deburr.motion import Kind
from deburr.motion.arcs import points

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from deburr.motion import Arc, Path
    from deburr.motion.path import Point
    from deburr.plot.extent import Extent

MOST = 200_000
"""More segments than these are not drawn one by one."""
_FINE = 1_000
"""The first tolerance that is tried: this part of the way across, less than a pixel of most pictures."""


class Segment(NamedTuple):
    """A straight line or an arc. ``tool``: the index of its tool in the path; ``rapid``: it does not cut."""

    start: Point
    end: Point
    rapid: bool
    tool: int
    arc: Arc | None = None


class Drawn(NamedTuple):
    """What is drawn of ``total`` segments. ``tolerance``: what is left out lies within so many mm of it; 0: nothing is."""

    segments: Sequence[Segment]
    total: int
    tolerance: float


def drawn(path: Path, reach: Extent, most: int = MOST) -> Drawn:
    """The segments of a path that reaches so far: at most so many."""
    total = len(path) - sum(kind == Kind.SHIFT for kind in path.kinds)
    if total <= most:
        return Drawn(list(_segments(path)), total, 0.0)
    tolerance = reach.size / _FINE
    while True:
        # Half of it is for arcs, which become chords.
        found = _clustered(path, reach.low, tolerance / 2, most)
        if found is not None:
            return Drawn(found, total, tolerance)
        tolerance *= 1.4


def _segments(path: Path) -> Iterator[Segment]:
    start = path.start
    columns = zip(path.kinds, path.x, path.y, path.z, path.tool)
    for index, (kind, x, y, z, tool) in enumerate(columns):
        end = (x, y, z)
        if kind != Kind.SHIFT:
            yield Segment(start, end, kind == Kind.RAPID, tool, path.arc(index) if kind == Kind.ARC else None)
        start = end


def _clustered(path: Path, low: Point, tolerance: float, most: int) -> list[Segment] | None:
    """All points of a cell are drawn as its first one, the same segment once; None if that are still too many.

    A cell's diagonal is the tolerance: no point moves further, so no point of a segment does.
    """
    cells = sqrt(3) / tolerance
    left, front, bottom = low
    firsts: dict[tuple[int, int, int], Point] = {}
    found: dict[tuple[Point, Point, bool], Segment] = {}

    def nearest(point: Point) -> Point:
        x, y, z = point
        cell = (int((x - left) * cells), int((y - front) * cells), int((z - bottom) * cells))
        return firsts.setdefault(cell, point)

    start = nearest(path.start)
    for index, (kind, x, y, z, tool) in enumerate(zip(path.kinds, path.x, path.y, path.z, path.tool)):
        rapid = kind == Kind.RAPID
        for point in _points(path, index, tolerance) if kind == Kind.ARC else ((x, y, z),):
            end = nearest(point)
            if start is not end and kind != Kind.SHIFT:
                key = (start, end, rapid) if start < end else (end, start, rapid)
                if key not in found:
                    if len(found) == most:
                        return None
                    found[key] = Segment(start, end, rapid, tool)
            start = end
    return list(found.values())


def _points(path: Path, index: int, tolerance: float) -> Iterator[Point]:
    arc = path.arc(index)
    assert arc is not None
    return points(arc, tolerance)
