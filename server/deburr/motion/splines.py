"""Splines of G5 and G5.1 as points. Never judges a program."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

PIECES = 32
"""Chords in place of one spline."""


def points(
    code: int, start: Sequence[float], end: Sequence[float], words: Mapping[str, float], unit: float
) -> Iterator[list[float]]:
    """Points along a spline behind its start: G5 (50) is cubic, with I, J from the start and P, Q from the end to its inner points; G5.1 (51) quadratic, with one."""
    first = (start[0] + words.get("I", 0.0) * unit, start[1] + words.get("J", 0.0) * unit)
    ends = [(start[0], start[1]), (end[0], end[1])]
    inner = (
        [first] if code == 51 else [first, (end[0] + words.get("P", 0.0) * unit, end[1] + words.get("Q", 0.0) * unit)]
    )
    for number in range(1, PIECES):
        part = number / PIECES
        x, y = _point([ends[0], *inner, ends[1]], part)
        yield [x, y, *(a + (b - a) * part for a, b in zip(start[2:], end[2:]))]
    yield list(end)


def _point(controls: Sequence[tuple[float, float]], part: float) -> tuple[float, float]:
    """By de Casteljau: between neighbours, again and again."""
    while len(controls) > 1:
        controls = [(a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part) for a, b in pairwise(controls)]
    return controls[0]
