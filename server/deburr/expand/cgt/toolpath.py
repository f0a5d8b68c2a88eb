"""CL text as events: which section runs with which words set (spec/cgt.md §6, §11, *CL to events*). Runs nothing, knows no template."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.cgt import equal
from deburr.formats.cl import Statement, plane

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from deburr.formats import Fault

Values = tuple[tuple[str, float | str], ...]
_Point = tuple[float, float, float]
_ON_CIRCLE = 0.001
"""How far from a circle a point may lie that still belongs to its arc (spec/cgt.md §11)."""
_COOLANT = {"OFF": 0.0, "ON": 1.0, "FLOOD": 1.0, "MIST": 2.0}
_SIDE = {"OFF": 0.0, "LEFT": 1.0, "RIGHT": 2.0}
_TURN = {"OFF": 0.0, "CLW": 1.0, "CCLW": 2.0}
_CYCLES = {"OFF": 0, "DRILL": 1, "CBORE": 2, "FACE": 2, "DEEP": 3, "BRKCHP": 3, "TAP": 4, "BORE": 5}
_PLANES = {2: (0, 1), 1: (2, 0), 0: (1, 2)}
"""The axes of the plane of an arc, by the axis that it turns around: seen from there, the second lies a quarter to the left of the first."""
_RAPID, _CUT = ("MOV", 0.0), ("MOV", 1.0)
_SECTIONS = {0: "YZARC", 1: "XZARC", 2: "ARC"}


class Event(NamedTuple):
    """Words are set, then a section runs; its name is empty where none does. ``line``: the statement's.

    ``element``: whether it is a move, an arc, a hole or a dwell; ``length``: how far it cuts.
    """

    line: int
    section: str = ""
    values: Values = ()
    element: bool = False
    length: float = 0.0


class Toolpath:
    """Follows CL statements. ``absolute``: how arc centres are given; ``tool_in_start``: the first tool change runs nothing."""

    def __init__(self, absolute: bool, tool_in_start: bool) -> None:
        self._absolute = absolute
        self._waits_for_tool = tool_in_start
        self._at: _Point = (0.0, 0.0, 0.0)
        self._line = 0
        self._started = False
        self._change: int | None = None
        """The line of a tool change that has not run yet."""
        self._rapid = False
        self._cycle = 0
        self._circle: Statement | None = None
        self._end: tuple[int, _Point] | None = None
        """The last point of the arc so far, and its line."""

    def events(self, statements: Iterable[Statement | Fault]) -> Iterator[Event]:
        """The events of a toolpath, `START` and `END` among them."""
        for each in statements:
            self._line = each.line
            if isinstance(each, Statement):
                if each.word == "GOTO":
                    yield from self._goto(each)
                    continue
                yield from self._end_arc()
                if each.word == "FINI":
                    break
                if (found := _WORDS.get(each.word)) is not None:
                    yield from found(self, each)
            elif each.ignored:
                yield from self._end_arc()
        yield from self._end_arc()
        yield from self._element(Event(self._line, "END"))

    def load_tool(self, statement: Statement) -> Iterator[Event]:
        """A tool change waits for the next element, so that it knows the spindle's speed."""
        if self._change is not None:
            yield from self._before(statement.line)
        if self._waits_for_tool:
            self._waits_for_tool = False
        else:
            self._change = statement.line
        number = statement.numbers[0]
        yield Event(statement.line, values=(("TOOL", number), ("NTOOL", number)))

    def spindle(self, statement: Statement) -> Iterator[Event]:
        """Speed and sense."""
        speed = tuple(("SPEED", number) for number in statement.numbers)
        yield Event(statement.line, values=(*speed, ("SPNDL", _TURN[statement.choices[-1]])))

    def feed(self, statement: Statement) -> Iterator[Event]:
        """Feed rate."""
        yield Event(statement.line, values=(("FEED", statement.numbers[0]),))

    def units(self, statement: Statement) -> Iterator[Event]:
        """Inch or millimetre."""
        yield Event(statement.line, values=(("UNITS", 1.0 if statement.choices[0] == "MM" else 0.0),))

    def coolant(self, statement: Statement) -> Iterator[Event]:
        """Coolant."""
        yield Event(statement.line, values=(("COOLNT", _COOLANT[statement.choices[0]]),))

    def compensation(self, statement: Statement) -> Iterator[Event]:
        """Cutter compensation and its offset."""
        offset = tuple(("DOFF", number) for number in statement.numbers)
        yield Event(statement.line, values=(("DCOMP", _SIDE[statement.choices[0]]), *offset))

    def cycle(self, statement: Statement) -> Iterator[Event]:
        """A canned cycle for the points that follow, or its end."""
        self._cycle = _CYCLES[statement.choices[0]]
        yield Event(statement.line, values=(("CYCLE", float(self._cycle)),))

    def title(self, statement: Statement) -> Iterator[Event]:
        """The program's title."""
        yield Event(statement.line, values=(("FILE", statement.text),))

    def dwell(self, statement: Statement) -> Iterator[Event]:
        """A dwell is an element."""
        yield from self._element(Event(statement.line, "DWELL", (("DWELL", statement.numbers[0]),), True))

    def rapid(self, statement: Statement) -> Iterator[Event]:
        """The next point is reached in rapid."""
        # Behind a CIRCLE and in a cycle it means nothing.
        self._rapid = self._circle is None and not self._cycle
        yield from ()

    def start_at(self, statement: Statement) -> Iterator[Event]:
        """Where the first move starts."""
        self._at = _point(statement)
        yield from ()

    def circle(self, statement: Statement) -> Iterator[Event]:
        """The circle on which the next points lie."""
        self._circle, self._rapid = statement, False
        yield from ()

    def _goto(self, statement: Statement) -> Iterator[Event]:
        to = _point(statement)
        if self._cycle:
            self._circle = None
        if self._circle is not None:
            if self._end is None or _lies_on(self._circle, to):
                self._end = (statement.line, to)
                return
            yield from self._end_arc()
        if not self._started or self._change is not None:
            yield from self._before(statement.line)
        yield self._move(statement.line, to)
        self._rapid = False
        self._at = to

    def _move(self, line: int, to: _Point) -> Event:
        """A straight move, or a hole of a cycle."""
        ends = self._from_to(to)
        if self._cycle:
            return Event(line, f"FXD{self._cycle}", ends, True)
        if self._rapid:
            return Event(line, "RAP", (_RAPID, *ends), True)
        return Event(line, "LINE", (_CUT, *ends), True, math.dist(self._at, to))

    def _end_arc(self) -> Iterator[Event]:
        """The arc whose points are all known."""
        if self._circle is None or self._end is None:
            return
        circle, (line, to) = self._circle, self._end
        self._circle = self._end = None
        axis, sense = plane(circle) or (2, 1)
        centre = _point(circle)
        origin = (0.0, 0.0, 0.0) if self._absolute else self._at
        offsets = [(name, c - o) for name, c, o in zip(("XCTR", "YCTR", "ZCTR"), centre, origin)]
        section = "HELIX" if axis == 2 and not equal(self._at[2], to[2]) else _SECTIONS[axis]
        moves: Values = (("MOV", 2.0 if sense < 0 else 3.0), ("ARAD", circle.numbers[6]))
        values = (*moves, *offsets, *self._from_to(to))
        yield from self._element(Event(line, section, values, True, self._arc_length(circle, axis, sense, to)))
        self._at = to

    def _arc_length(self, circle: Statement, axis: int, sense: int, to: _Point) -> float:
        first, second = _PLANES[axis]
        centre = _point(circle)
        start, end = (math.atan2(at[second] - centre[second], at[first] - centre[first]) for at in (self._at, to))
        turned = (end - start) * sense % math.tau or math.tau
        return math.hypot(circle.numbers[6] * turned, to[axis] - self._at[axis])

    def _from_to(self, to: _Point) -> Values:
        x, y, z = self._at
        return ("XST", x), ("YST", y), ("ZST", z), ("XPOS", to[0]), ("YPOS", to[1]), ("ZPOS", to[2])

    def _element(self, event: Event) -> Iterator[Event]:
        yield from self._before(event.line)
        yield event

    def _before(self, line: int) -> Iterator[Event]:
        """What runs before an element: once the start, and a tool change that waits."""
        if not self._started:
            self._started = True
            yield Event(line, "START")
        if self._change is not None:
            change, self._change = self._change, None
            yield Event(change, "TOOLCHG")


_WORDS: dict[str, Callable[[Toolpath, Statement], Iterator[Event]]] = {
    "LOADTL": Toolpath.load_tool,
    "SPINDL": Toolpath.spindle,
    "FEDRAT": Toolpath.feed,
    "UNITS": Toolpath.units,
    "COOLNT": Toolpath.coolant,
    "CUTCOM": Toolpath.compensation,
    "CYCLE": Toolpath.cycle,
    "PARTNO": Toolpath.title,
    "DELAY": Toolpath.dwell,
    "RAPID": Toolpath.rapid,
    "FROM": Toolpath.start_at,
    "CIRCLE": Toolpath.circle,
}


def _point(statement: Statement) -> _Point:
    x, y, z = statement.numbers[:3]
    return x, y, z


def _lies_on(circle: Statement, point: _Point) -> bool:
    axis, _ = plane(circle) or (2, 1)
    first, second = _PLANES[axis]
    away = math.hypot(point[first] - circle.numbers[first], point[second] - circle.numbers[second])
    return abs(away - circle.numbers[6]) <= _ON_CIRCLE
