"""What stands in a path: how far it reaches, how long it is, how long it takes, with which tools. Never reads a program.

Times are estimates: each move at its feed, or at the rapid rate of the machine, without acceleration.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from deburr.motion import arcs
from deburr.motion.path import Flag, Happening, Kind, Path, Point

RAPID = 5000.0
"""Millimetres a minute of rapids where nothing is configured."""
Bounds = dict[str, tuple[float, float]]
"""The least and the greatest coordinate by axis: mm, degrees for A, B and C."""
_CUTS = (Kind.FEED, Kind.ARC, Kind.PROBE, Kind.THREAD)
_AXES = "XYZ"
_PER_REVOLUTION, _INVERSE = int(Flag.PER_REVOLUTION), int(Flag.INVERSE)


@dataclass
class Use:
    """What is done with a tool: how many moves, mm of cuts, seconds in all. ``number``: 0 is the spindle as it is found."""

    number: int
    moves: int = 0
    cut: float = 0.0
    seconds: float = 0.0


@dataclass
class Measure:
    """All of it. Lengths are in mm, times in seconds."""

    moves: int = 0
    arcs: int = 0
    bounds: Bounds = field(default_factory=dict)
    rapid_bounds: Bounds = field(default_factory=dict)
    cut_bounds: Bounds = field(default_factory=dict)
    rapid: float = 0.0
    """Length of rapids."""
    cut: float = 0.0
    """Length of cuts, probing and threads among them."""
    rapid_seconds: float = 0.0
    cut_seconds: float = 0.0
    dwell_seconds: float = 0.0
    untimed: int = 0
    """Cuts without a feed: they are in no time."""
    tools: tuple[Use, ...] = ()

    @property
    def seconds(self) -> float:
        """How long it takes in all."""
        return self.rapid_seconds + self.cut_seconds + self.dwell_seconds


def measured(path: Path, rapid: Mapping[str, float] | None = None) -> Measure:
    """The measure of a path; ``rapid``: mm/min (degrees/min) of an axis, as far as they are known."""
    found = Measure()
    uses = {number: Use(number) for number in path.tools}
    found.dwell_seconds = sum(event.value for event in path.events if event.what is Happening.DWELL)
    speeds, speed = _speeds(path), 0.0
    change, after = next(speeds)
    for index, (kind, start, end) in enumerate(_steps(path)):
        while index >= change:
            speed = after
            change, after = next(speeds)
        if kind == Kind.SHIFT:
            continue
        use = uses[path.tools[path.tool[index]]]
        found.moves += 1
        use.moves += 1
        arc = path.arc(index) if kind == Kind.ARC else None
        way = arcs.length(arc) if arc is not None else math.dist(start, end)
        beside = _beside(path, index) if path.beside else {}
        if kind == Kind.RAPID:
            found.rapid += way
            seconds = _rapid_seconds(start, end, beside, rapid or {})
            found.rapid_seconds += seconds
        else:
            found.arcs += arc is not None
            found.cut += way
            use.cut += way
            feed = _feed(path, index, way or max(beside.values(), default=0.0), speed)
            found.untimed += feed is None
            seconds = feed or 0.0
            found.cut_seconds += seconds
        use.seconds += seconds
    found.rapid_bounds, found.cut_bounds = _bounds(path, (Kind.RAPID,)), _bounds(path, _CUTS)
    found.bounds = _joined(found.rapid_bounds, found.cut_bounds)
    found.tools = tuple(use for use in uses.values() if use.moves)
    return found


def _steps(path: Path) -> Iterator[tuple[int, Point, Point]]:
    start = path.start
    for kind, *end in zip(path.kinds, path.x, path.y, path.z):
        point = (end[0], end[1], end[2])
        yield kind, start, point
        start = point


def _speeds(path: Path) -> Iterator[tuple[int, float]]:
    """From which move on the spindle turns how fast; at last a move that never comes."""
    for event in path.events:
        if event.what is Happening.SPINDLE:
            yield event.at, abs(event.value)
    yield len(path) + 1, 0.0


def _beside(path: Path, index: int) -> dict[str, float]:
    """How far the other axes go."""
    return {
        axis: abs(column[index] - (column[index - 1] if index else 0.0))
        for axis, column in path.beside.items()
        if column[index] != (column[index - 1] if index else 0.0)
    }


def _rapid_seconds(start: Point, end: Point, beside: Mapping[str, float], rapid: Mapping[str, float]) -> float:
    """All axes start and arrive together: the one that takes longest decides. An axis without a rate has the slowest one."""
    slowest = min(rapid.values(), default=RAPID)
    ways = {axis: abs(b - a) for axis, a, b in zip(_AXES, start, end)} | dict(beside)
    if not rapid:
        return 60 * max(math.dist(start, end), *beside.values(), 0.0) / RAPID
    return 60 * max((way / rapid.get(axis, slowest) for axis, way in ways.items()), default=0.0)


def _feed(path: Path, index: int, way: float, speed: float) -> float | None:
    """Seconds of a cut; None: it has no feed."""
    feed, flags = path.feeds[index], path.flags[index]
    if flags & _PER_REVOLUTION:
        feed *= speed
    if flags & _INVERSE:
        return 60 / feed if feed > 0 else None
    return 60 * way / feed if feed > 0 else None if way else 0.0


def _bounds(path: Path, kinds: tuple[Kind, ...]) -> Bounds:
    """Where moves of these kinds start, pass and end."""
    wanted = bytes(kind in kinds for kind in range(max(Kind) + 1))
    here = bytes(path.kinds).translate(wanted.ljust(256, b"\0"))
    # A move starts where the one before it ends.
    ends = bytes(a | b for a, b in zip(here, here[1:] + b"\0"))
    if not any(here):
        return {}
    found = Bounds()
    columns = [*zip(_AXES, (path.x, path.y, path.z), path.start), *((a, c, 0.0) for a, c in path.beside.items())]
    for axis, column, first in columns:
        values = [value for value, on in zip(column, ends) if on]
        values += [first] if here[0] else []
        found[axis] = (min(values), max(values))
    if Kind.ARC in kinds:
        for index in path.arcs[0]:
            arc = path.arc(index)
            assert arc is not None
            for axis, low, high in zip(_AXES, *arcs.extremes(arc)):
                found[axis] = (min(found[axis][0], low), max(found[axis][1], high))
    return found


def _joined(one: Bounds, other: Bounds) -> Bounds:
    axes = [axis for axis in "XYZABCUVW" if axis in one or axis in other]
    both = {axis: [bounds[axis] for bounds in (one, other) if axis in bounds] for axis in axes}
    return {axis: (min(low for low, _ in found), max(high for _, high in found)) for axis, found in both.items()}
