"""The axes of an RS274 machine, and sums of coordinates of which only the machine may know some. Knows no program."""

import math

AXES = "XYZABCUVW"
LINEAR = frozenset((0, 1, 2, 6, 7, 8))
"""The numbers of axes that are measured as lengths; the others are angles."""
MACHINE_UNIT = 25.4
"""Millimetres in the stand-alone interpreter's own unit."""
Coordinates = list[float | None]
"""One for each axis; None: only the machine knows."""


def plus(a: float | None, b: float | None) -> float | None:
    """A sum, if both are known."""
    return None if a is None or b is None else a + b


def minus(a: float | None, b: float | None) -> float | None:
    """A difference, if both are known."""
    return None if a is None or b is None else a - b


def times(a: float | None, factor: float) -> float | None:
    """So many times a value, if it is known."""
    return None if a is None else a * factor


def turned(point: Coordinates, degrees: float) -> Coordinates:
    """A point turned about the origin in X and Y; if one of the two is not known, neither is any more."""
    if not degrees:
        return list(point)
    x, y, *others = point
    if x is None or y is None:
        return [None, None, *others]
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return [x * cos - y * sin, x * sin + y * cos, *others]
