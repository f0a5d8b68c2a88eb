"""The record of a program's moves: columns that only grow while it is made, and a `Path` that only reads them.

Points are where the tool's tip is, in millimetres, in the machine's coordinates: offsets of work
systems, G92 and rotations are in them, tool lengths are not. A move takes some 40 bytes,
an arc 29 more. Never reads a program.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left, bisect_right
from dataclasses import dataclass
from enum import IntEnum, IntFlag
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence

TURNED = "ABC"
"""Axes in degrees."""
BESIDE = "ABCUVW"
"""Axes that have a column only if a program moves them: A, B, C in degrees, U, V, W in millimetres."""
Point = tuple[float, float, float]


class Kind(IntEnum):
    """What a move is."""

    RAPID = 0
    FEED = 1
    ARC = 2
    """At the feed, along an arc or a helix, which `Path.arc` has."""
    PROBE = 3
    """G38: at the feed, as far as the program wants to go."""
    THREAD = 4
    """G33, G33.1, G76, and tapping: bound to the spindle."""
    SHIFT = 5
    """No motion: from here on another point is the tip, since another tool length holds. Not to be drawn, of no length."""


class Flag(IntFlag):
    """What else holds for a move."""

    ASSUMED = 1
    """It starts or ends where only the machine knows (G28, G53 without known offsets); the point is what zeros in their place give."""
    CYCLE = 2
    """A canned cycle makes it."""
    COMPENSATED = 4
    """Cutter compensation is on: the tool runs beside this way, which is the one that was programmed."""
    SPINDLE = 8
    """The spindle turns."""
    PER_REVOLUTION = 16
    """G95: the feed is in millimetres a revolution."""
    INVERSE = 32
    """G93: the feed says how often a minute the move could be made."""
    SIDEWAYS = 64
    """It moves across the axis of the tool in the plane that is active, whatever else."""
    MACHINE = 128
    """G53: the axes that it moves go to places of the machine's own, whatever offsets are not known."""


class Happening(IntEnum):
    """What happens between moves; in brackets what the value of its event says."""

    DWELL = 0
    """Waiting (seconds)."""
    TOOL = 1
    """Another tool (its number)."""
    SPINDLE = 2
    """The spindle (revolutions a minute; below 0 counterclockwise, 0 off)."""
    COOLANT = 3
    """Coolant (0 off, 1 mist, 2 flood, 3 both)."""
    SYSTEM = 4
    """Work system (1 to 9 for G54 to G59.3), or its offsets."""
    SHIFTED = 5
    """G92 or G52 (1 in force, 0 not)."""
    LENGTH = 6
    """Tool length (the index of its offset in `Path.lengths`)."""
    PLANE = 7
    """Plane (17, 18, 19)."""
    COMPENSATION = 8
    """Cutter compensation (41, 42; 40 off)."""
    UNITS = 9
    """Unit of lengths in the program (millimetres in it)."""
    STOP = 10
    """Stop (0 M0, 1 M1, 60 M60)."""
    END = 11
    """End of the program (2 M2, 30 M30)."""


class Move(NamedTuple):
    """One move. ``flat``: the 0-based line of the flat program; ``feed``: mm/min unless flags say otherwise, 0 none; ``tool``: its number."""

    kind: Kind
    end: Point
    flat: int
    feed: float
    tool: int
    flags: Flag


class Arc(NamedTuple):
    """An arc or helix from ``start`` to ``end``. ``plane``: 17, 18 or 19; ``centre``: along the plane's first and second axis.

    Those axes are X and Y in plane 17, Z and X in 18, Y and Z in 19. ``turns``: started turns about the
    centre, positive from the first axis to the second (G3), negative the other way (G2); a whole circle is one.
    """

    start: Point
    end: Point
    plane: int
    centre: tuple[float, float]
    turns: int


class Event(NamedTuple):
    """Something that happens before the move of index ``at`` (the count of moves: behind the last one)."""

    at: int
    flat: int
    what: Happening
    value: float


class Zeros(NamedTuple):
    """From the move of index ``at`` on: whether nothing gives the work offset, and of which tool nothing gives the length (0: none)."""

    at: int
    system: bool
    tool: int


class Note(NamedTuple):
    """Something of a line that the moves do not show, in words."""

    flat: int
    text: str


@dataclass(frozen=True, eq=False)
class Path:
    """A program's moves in the order in which they are made. Columns are read-only views with an entry for each move."""

    kinds: memoryview
    """`Kind` (B)."""
    flags: memoryview
    """`Flag` (B)."""
    x: memoryview[float]
    """Where the moves end, in mm (d)."""
    y: memoryview[float]
    z: memoryview[float]
    flat: memoryview
    """The flat line of each move, 0-based; it never falls (i)."""
    feeds: memoryview[float]
    """The feed that holds (f)."""
    tool: memoryview
    """The index of the tool in ``tools`` (H)."""
    unknown: memoryview
    """Axes of which the program has not said where they are when a move ends, nor anything before it: bit n is axis n of XYZABCUVW (H)."""
    beside: Mapping[str, memoryview[float]]
    """The other axes, as far as they are used (d)."""
    tools: tuple[int, ...]
    """Numbers of tools in the order in which they come; the first is the one at the start, 0 for none."""
    start: Point
    arcs: tuple[memoryview, memoryview, memoryview[float], memoryview[float], memoryview]
    """Of each arc: the index of its move (i), its plane (B), its centre (d, d), its turns (i)."""
    events: Events
    notes: tuple[Note, ...]
    lengths: tuple[tuple[float, ...], ...]
    """Tool length offsets that were used, along X, Y, Z; one that is not known is of zeros."""
    zeros: tuple[Zeros, ...] = ()
    """What counts as zero because nothing gives it, each time that this changes."""

    def __len__(self) -> int:
        return len(self.kinds)

    def __getitem__(self, index: int) -> Move:
        end = (self.x[index], self.y[index], self.z[index])
        tool = self.tools[self.tool[index]]
        return Move(Kind(self.kinds[index]), end, self.flat[index], self.feeds[index], tool, Flag(self.flags[index]))

    def moves(self) -> Iterator[Move]:
        """All of them."""
        return map(self.__getitem__, range(len(self)))

    def before(self, index: int) -> Point:
        """Where a move starts."""
        return (self.x[index - 1], self.y[index - 1], self.z[index - 1]) if index else self.start

    def arc(self, index: int) -> Arc | None:
        """The arc of a move; None if it is straight."""
        if self.kinds[index] != Kind.ARC:
            return None
        at, planes, first, second, turns = self.arcs
        number = bisect_left(at, index)
        end = (self.x[index], self.y[index], self.z[index])
        return Arc(self.before(index), end, planes[number], (first[number], second[number]), turns[number])

    def of_line(self, flat: int) -> range:
        """The indices of the moves that a flat line makes."""
        return range(bisect_left(self.flat, flat), bisect_right(self.flat, flat))


class Recorder:
    """Makes a path, move by move."""

    def __init__(self, start: Point = (0.0, 0.0, 0.0)) -> None:
        self._start = start
        self._kinds, self._flags = array("B"), array("B")
        self._x, self._y, self._z = array("d"), array("d"), array("d")
        self._flat, self._feeds, self._tool = array("i"), array("f"), array("H")
        self._unknown = array("H")
        self._beside: dict[str, array[float]] = {}
        self._tools = [0]
        self._now = 0
        self._arcs: tuple[array[Any], ...] = (array("i"), array("B"), array("d"), array("d"), array("i"))
        self._events: tuple[array[Any], ...] = (array("i"), array("i"), array("B"), array("d"))
        self._notes: dict[str, Note] = {}
        self._lengths: list[tuple[float, ...]] = []
        self._zeros: list[Zeros] = []
        columns: tuple[array[Any], ...] = (
            self._kinds, self._flags, self._x, self._y, self._z, self._flat, self._feeds, self._tool,
            self._unknown,
        )  # fmt: skip
        self._puts: tuple[Callable[[float], None], ...] = tuple(column.append for column in columns)

    def move(self, kind: int, flags: int, end: Sequence[float], flat: int, feed: float, unknown: int = 0) -> None:
        """A move to a point: X, Y, Z, and as many of A, B, C, U, V, W as there are. ``unknown``: see `Path.unknown`."""
        kinds, marks, x, y, z, flats, feeds, tools, unknowns = self._puts
        kinds(kind)
        marks(flags)
        x(end[0])
        y(end[1])
        z(end[2])
        flats(flat)
        feeds(feed)
        tools(self._now)
        unknowns(unknown)
        if self._beside or len(end) > 3:
            self._also(end)

    def arc(self, plane: int, centre: tuple[float, float], turns: int) -> None:
        """What the move that was put last went about."""
        for column, value in zip(self._arcs, (len(self._kinds) - 1, plane, *centre, turns)):
            column.append(value)

    def event(self, flat: int, what: Happening, value: float) -> None:
        """Something that happens before the next move."""
        if what is Happening.TOOL:
            number = round(value)
            if number not in self._tools:
                self._tools.append(number)
            self._now = self._tools.index(number)
        for column, each in zip(self._events, (len(self._kinds), flat, what, value)):
            column.append(each)

    def length(self, flat: int, offset: Sequence[float]) -> None:
        """Another tool length holds."""
        said = tuple(offset)
        if said not in self._lengths:
            self._lengths.append(said)
        self.event(flat, Happening.LENGTH, self._lengths.index(said))

    def zero(self, system: bool, tool: int) -> None:
        """This counts as zero for the next move, as `Path.zeros` has it."""
        if not self._zeros or self._zeros[-1][1:] != (system, tool):
            self._zeros.append(Zeros(len(self._kinds), system, tool))

    def note(self, flat: int, text: str) -> None:
        """Something to be said; the same is said once, where it comes first."""
        self._notes.setdefault(text, Note(flat, text))

    def path(self) -> Path:
        """What was recorded. Nothing can be added any more."""
        index, plane, first, second, turns = self._arcs
        at, flat, what, value = self._events
        return Path(
            _view(self._kinds), _view(self._flags), _view(self._x), _view(self._y), _view(self._z),
            _view(self._flat), _view(self._feeds), _view(self._tool), _view(self._unknown),
            {axis: _view(column) for axis, column in self._beside.items()},
            tuple(self._tools),
            self._start,
            (_view(index), _view(plane), _view(first), _view(second), _view(turns)),
            Events(_view(at), _view(flat), _view(what), _view(value)),
            tuple(self._notes.values()),
            tuple(self._lengths),
            tuple(self._zeros),
        )  # fmt: skip

    def _also(self, end: Sequence[float]) -> None:
        """Put the other axes down; those of which nothing is said stay where they are."""
        for at, axis in enumerate(BESIDE, 3):
            column = self._beside.get(axis)
            if column is None:
                if len(end) <= at or not end[at]:
                    continue
                column = self._beside[axis] = array("d", bytes(8 * (len(self._kinds) - 1)))
            column.append(end[at] if len(end) > at else column[-1] if column else 0.0)


class Events:
    """Events in columns: a program may have one on each line."""

    def __init__(self, at: memoryview, flat: memoryview, what: memoryview, value: memoryview[float]) -> None:
        self._columns = (at, flat, what, value)

    def __len__(self) -> int:
        return len(self._columns[0])

    def __getitem__(self, index: int) -> Event:
        at, flat, what, value = self._columns
        return Event(at[index], flat[index], Happening(what[index]), value[index])

    def __iter__(self) -> Iterator[Event]:
        return map(self.__getitem__, range(len(self)))


def _view(column: array[Any]) -> memoryview[Any]:
    return memoryview(column).toreadonly()
