"""From space to a flat picture: the directions from which a path is looked at, and curves as they look from there. Knows no format."""

from __future__ import annotations

from math import atan2, degrees, hypot, sqrt
from typing import TYPE_CHECKING, NamedTuple

from deburr.motion.arcs import AXES_OF

if TYPE_CHECKING:
    from deburr.motion import Arc
    from deburr.motion.path import Point

_FLAT = 1e-9
"""Millimetres, or parts of a radius, that are nothing."""


class View(NamedTuple):
    """A direction to look from: what goes right and what goes up on the picture, as unit vectors."""

    name: str
    right: Point
    up: Point
    axes: str
    """The axes that lie along right and up; none where it looks across."""

    def seen(self, point: Point) -> tuple[float, float]:
        """Where a point is, right and up."""
        return _dot(self.right, point), _dot(self.up, point)


_THIRD, _SIXTH, _HALF = 1 / sqrt(3), 1 / sqrt(6), 1 / sqrt(2)
ISOMETRIC = View("isometric", (_HALF, _HALF, 0.0), (-_SIXTH, _SIXTH, 2 * _SIXTH), "")
"""From the right, in front and above."""
TOP = View("top", (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), "XY")
FRONT = View("front", (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), "XZ")
SIDE = View("right side", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), "YZ")


class Ellipse(NamedTuple):
    """What a circle looks like: both half axes, and degrees from right to the first of them, counterclockwise."""

    first: float
    second: float
    turned: float
    same: bool
    """Whether it goes round as the circle does, counterclockwise for positive turns."""


def ellipse(arc: Arc, view: View) -> Ellipse | None:
    """The ellipse on which an arc lies as it is seen; None where it is none: a helix from aside, an arc seen edge-on, a spiral."""
    first, second, across = AXES_OF[arc.plane]
    radii = [hypot(point[first] - arc.centre[0], point[second] - arc.centre[1]) for point in (arc.start, arc.end)]
    radius = radii[0]
    if abs(radii[1] - radius) > 1e-3 * radius:
        return None
    if abs(arc.end[across] - arc.start[across]) > _FLAT and hypot(view.right[across], view.up[across]) > _FLAT:
        return None
    # Singular values of the circle's two axes as they are seen: M = rotation * (first, second) * rotation.
    a, b, c, d = view.right[first], view.right[second], view.up[first], view.up[second]
    turned, mirrored = hypot(a + d, c - b) / 2, hypot(a - d, c + b) / 2
    if abs(turned - mirrored) < _FLAT:
        return None
    angle = (atan2(c - b, a + d) + atan2(c + b, a - d)) / 2
    return Ellipse(radius * (turned + mirrored), radius * abs(turned - mirrored), degrees(angle), turned > mirrored)


def _dot(one: Point, other: Point) -> float:
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
