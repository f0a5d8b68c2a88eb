"""Arcs and helixes: centres, sweeps, lengths, extremes and chords. Never reads a program.

A control accepts a small difference of the radius at both ends; between them the radius is taken to change evenly.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.motion.path import Arc, Point

AXES_OF = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}
"""Of each plane its first and second axis, and the one across it."""
_FUZZ = 1e-6
"""Radians under which a sweep counts as a whole circle, as the control's own planner has it."""
_QUARTER = math.pi / 2


def centre_by_radius(
    start: tuple[float, float], end: tuple[float, float], radius: float, clockwise: bool
) -> tuple[float, float]:
    """The centre of an arc of this radius; below 0 it is the arc of more than half a circle. Too small a radius counts as half the way (spec/rs274.md §8, *arc-form*)."""
    half = math.dist(start, end) / 2
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    if half == 0:
        return middle
    height = math.sqrt(max(radius * radius - half * half, 0.0))
    side = height if clockwise == (radius < 0) else -height
    return (
        middle[0] - side * (end[1] - start[1]) / (2 * half),
        middle[1] + side * (end[0] - start[0]) / (2 * half),
    )


def sweep(arc: Arc) -> float:
    """The angle that an arc goes, in radians, positive from the first axis to the second."""
    first, second, _ = AXES_OF[arc.plane]
    (a, b), start, end = arc.centre, arc.start, arc.end
    way = math.atan2(end[second] - b, end[first] - a) - math.atan2(start[second] - b, start[first] - a)
    if arc.turns < 0:
        way = -way
    way %= math.tau
    if way < _FUZZ or math.tau - way < _FUZZ:
        way = math.tau
    way += math.tau * (abs(arc.turns) - 1)
    return -way if arc.turns < 0 else way


def length(arc: Arc) -> float:
    """How long it is, in mm."""
    across = AXES_OF[arc.plane][2]
    start_radius, end_radius = _radii(arc)
    around = abs(sweep(arc)) * (start_radius + end_radius) / 2
    return math.hypot(around, end_radius - start_radius, arc.end[across] - arc.start[across])


def extremes(arc: Arc) -> tuple[Point, Point]:
    """The least and the greatest coordinate along each axis, exactly."""
    points = [arc.start, arc.end]
    way = sweep(arc)
    begin = _begin(arc)
    low, high = sorted((begin, begin + way))
    # A whole turn meets each extreme; the last one, and the first, are the widest.
    quarters = range(math.ceil(low / _QUARTER), math.floor(high / _QUARTER) + 1)
    shown = (*quarters[:4], *quarters[-4:]) if len(quarters) > 8 else quarters
    points += [_at(arc, (quarter * _QUARTER - begin) / way, way, begin) for quarter in shown]
    lows, highs = [list(map(choose, zip(*points))) for choose in (min, max)]
    return (lows[0], lows[1], lows[2]), (highs[0], highs[1], highs[2])


def points(arc: Arc, tolerance: float) -> Iterator[Point]:
    """Points along an arc behind its start, the last of them its end: their chords are nowhere further than ``tolerance`` (mm, above 0) from it."""
    radius = max(_radii(arc))
    way = sweep(arc)
    step = 2 * math.acos(1 - tolerance / radius) if radius > tolerance else math.pi / 2
    count = max(math.ceil(abs(way) / step), 1)
    begin = _begin(arc)
    for number in range(1, count):
        yield _at(arc, number / count, way, begin)
    yield arc.end


def _radii(arc: Arc) -> tuple[float, float]:
    first, second, _ = AXES_OF[arc.plane]
    start, end = (math.dist((point[first], point[second]), arc.centre) for point in (arc.start, arc.end))
    return start, end


def _begin(arc: Arc) -> float:
    first, second, _ = AXES_OF[arc.plane]
    return math.atan2(arc.start[second] - arc.centre[1], arc.start[first] - arc.centre[0])


def _at(arc: Arc, part: float, way: float, begin: float) -> Point:
    """The point behind a part (0 to 1) of an arc."""
    first, second, across = AXES_OF[arc.plane]
    start_radius, end_radius = _radii(arc)
    radius = start_radius + (end_radius - start_radius) * part
    angle = begin + way * part
    found = [0.0, 0.0, 0.0]
    found[first] = arc.centre[0] + radius * math.cos(angle)
    found[second] = arc.centre[1] + radius * math.sin(angle)
    found[across] = arc.start[across] + (arc.end[across] - arc.start[across]) * part
    return (found[0], found[1], found[2])
