"""What lies between the coordinates of a program and the machine: work systems, their rotation, G92 and G52, tool offsets, as far as text or settings tell it. Never guesses: None is what only the machine knows.

A point of the program is turned about the origin of its system: machine = system + turned(point + shift) + tool. What changes one of
these leaves the machine where it stands, and the coordinates of the program change, but for `G10 L2`, of which LinuxCNC's interpreter
reckons without the shift (spec/oracle.md).
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Set
from typing import TYPE_CHECKING, NamedTuple

from deburr.formats import parameters
from deburr.rules.rs274._moves import LINEAR, MM_PER_INCH, SYSTEMS, active_system, share_of
from deburr.rules.rs274._words import values, words

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr.modal import State
    from deburr.rule import Line
    from deburr.rules.rs274._words import Words

Point = tuple[float | None, float | None, float | None]
"""X, Y and Z in the units in force."""
HOME: Point = (0.0, 0.0, 0.0)
"""Where a program starts for the interpreter."""
_NOWHERE: Point = (None, None, None)
_FIRST, _EACH, _SHIFT, _ACTIVE, _SHIFTED = 5221, 20, 5211, 5220, 5210
"""Numbers of stored parameters: the first system, from one to the next, G92, which system is active, whether G92 is."""

_UNITS = {"mm": "G21", "inch": "G20"}


class Offsets(NamedTuple):
    """All of them. ``unit``: the code of the units of all lengths; "" for those in which a program starts, None where they are not known.

    ``kept``: what G92.3 would bring back.
    """

    unit: str | None = ""
    systems: tuple[Point, ...] = (_NOWHERE,) * len(SYSTEMS)
    turns: tuple[float | None, ...] = (None,) * len(SYSTEMS)
    shift: Point = _NOWHERE
    kept: Point = _NOWHERE
    tool: Point = _NOWHERE


UNKNOWN = Offsets()
"""Nothing is known."""


def unknown(steady: Set[str]) -> Offsets:
    """All that is known of offsets where nothing was told: that no tool has one along some axes."""
    x, y, z = (0.0 if axis in steady else None for axis in LINEAR)
    return UNKNOWN._replace(tool=(x, y, z))


def at_start(analysis: Analysis, steady: Set[str]) -> tuple[Offsets, Point]:
    """The offsets that stored parameters tell, and where the program starts for them. Their unit is the machine's: without `[machine]` only zero is certain."""
    path = analysis.settings["parameters"]
    text = analysis.host.read(path) if path else None
    if text is None:
        return unknown(steady), HOME
    read = parameters.read(text)
    # Which system is active, modal state takes for the first.
    if read.faults or read.values.get(_ACTIVE, 1) not in (0, 1):
        return unknown(steady), _NOWHERE
    unit = _UNITS.get(str(analysis.ruleset.machine.get("unit")), "")

    def point(first: int) -> Point:
        x, y, z = (_certain(read.values.get(first + axis, 0.0), unit) for axis in range(3))
        return x, y, z

    firsts = range(_FIRST, _FIRST + _EACH * len(SYSTEMS), _EACH)
    systems, kept = tuple(map(point, firsts)), point(_SHIFT)
    turns = tuple(read.values.get(first + 9, 0.0) for first in firsts)
    found = Offsets(unit, systems, turns, kept if read.values.get(_SHIFTED) else HOME, kept, HOME)
    x, y, z = (0.0 if a == b == 0 else None for a, b in zip(systems[0], found.shift))
    return found, (x, y, z) if x == y == 0 or not turns[0] else (None, None, z)


def behind(offsets: Offsets, point: Point, line: Line, state: State, steady: Set[str]) -> tuple[Offsets, Point]:
    """The offsets behind a line, and where the tool stands in them before the line's own move. ``steady``: axes along which no tool has an offset."""
    found = words(line)
    now = _Now(_in_units(offsets, _units(found, state)), point, active_number(state), steady)
    given = _given(line, found, state)
    if length := found.of("tool-length"):
        now.take_tool(length, given, is_first=state.untouched("tool-length"))
    if found.of("coordinate-system"):
        now.choose(SYSTEMS.index(found.of("coordinate-system")))
    if not found.has.isdisjoint(("G92.1", "G92.2", "G92.3")):
        now.unshift(found.has)
    elif "G92" in found.has:
        now.stand_at(given)
    elif "G52" in found.has:
        now.shift_by(given)
    elif "G10" in found.has:
        now.take_data(values(line), given)
    return now.offsets, now.point


def active_number(state: State) -> int | None:
    """The system in force, from 0; None where only the run knows it."""
    active = active_system(state)
    return None if active is None else SYSTEMS.index(active)


class _Now:
    """Offsets and place while a line is done."""

    def __init__(self, offsets: Offsets, point: Point, active: int | None, steady: Set[str]) -> None:
        self.offsets = offsets
        self.point = point
        self._active = active
        self._steady = steady

    def take_tool(self, code: str, given: Mapping[int, float | None], is_first: bool) -> None:
        """G43 to G43.2 and G49. A G49 to which nothing led is taken for one that changes nothing, as always."""
        old = self.offsets.tool
        tool: list[float | None] = [*HOME] if code == "G49" else [*old] if code == "G43.1" else [None] * 3
        if code == "G43.1":
            tool = [given.get(axis, value) for axis, value in enumerate(tool)]
        for axis, letter in enumerate(LINEAR):
            if letter in self._steady and code not in ("G43.1", "G49"):
                # What the table has is zero; G43.2 adds it.
                tool[axis] = old[axis] if code == "G43.2" else 0.0
        x, y, z = tool
        self.offsets = self.offsets._replace(tool=(x, y, z))
        if code == "G49" and is_first:
            return
        self._move(_turned(_minus(old, (x, y, z)), self._turn(self._active, -1)))

    def choose(self, number: int) -> None:
        """A coordinate system comes into force."""
        if number == self._active:
            return
        old, self._active = self._active, number
        way = _minus(self._system(old), self.offsets.systems[number])
        turn, new = self._turn(old), self.offsets.turns[number]
        if turn == new == 0:
            self._move(way)
            return
        shift = self.offsets.shift
        there = _plus(_turned(_plus(self.point, shift), turn), way)
        x, y, _ = _minus(_turned(there, None if new is None else -new), shift)
        self.point = x, y, _sum(self.point[2], way[2])

    def unshift(self, has: Collection[str]) -> None:
        """G92.1 to G92.3."""
        new = self.offsets.kept if "G92.3" in has else HOME
        self._move(_minus(self.offsets.shift, new))
        self.offsets = self.offsets._replace(shift=new, kept=HOME if "G92.1" in has else self.offsets.kept)

    def stand_at(self, given: Mapping[int, float | None]) -> None:
        """G92: the place is what is written."""
        here, self.point = self.point, _with(self.point, given)
        way = [_difference(a, b) if axis in given else 0.0 for axis, (a, b) in enumerate(zip(here, self.point))]
        self._shift(_plus(self.offsets.shift, (way[0], way[1], way[2])))

    def shift_by(self, given: Mapping[int, float | None]) -> None:
        """G52: what is written is the shift."""
        old = self.offsets.shift
        self._shift(_with(old, given))
        x, y, z = self.point
        way = _minus(old, self.offsets.shift)
        x, y, z = (_sum(each, way[axis]) if axis in given else each for axis, each in enumerate((x, y, z)))
        self.point = x, y, z

    def take_data(self, said: Mapping[str, float | None], given: Mapping[int, float | None]) -> None:
        """G10: L2 and L20 lay a system, all others change the table of tools alone."""
        kind, number, turn = said.get("L"), said.get("P"), said.get("R")
        if kind in (1, 10, 11):
            return
        if kind not in (2, 20) or number is None or number not in range(10) or (kind == 20 and "R" in said):
            self._lose()
            return
        system = self._active if number == 0 else int(number) - 1
        if system is None or (self._active is None and system != self._active):
            self._lose()
        elif kind == 2:
            self._lay(system, given, turn if "R" in said else self.offsets.turns[system])
        elif system == self._active:
            self._lay_here(system, given)
        else:
            self._lay_other(system, given)

    def _lay(self, system: int, given: Mapping[int, float | None], turn: float | None) -> None:
        old, before = self.offsets.systems[system], self.offsets.turns[system]
        self._set(system, _with(old, given), turn)
        if system != self._active:
            return
        way = _minus(old, self.offsets.systems[system])
        x, y, z = (_sum(each, way[axis] if axis in given else 0.0) for axis, each in enumerate(self.point))
        if before == turn == 0 or (before is turn is None and not {0, 1} & given.keys()):
            self.point = x, y, z
            return
        # The interpreter forgets the shift here.
        there = _plus(_turned(self.point, before), _only(way, given))
        x, y, _ = _turned(there, None if turn is None else -turn)
        self.point = x, y, z

    def _lay_here(self, system: int, given: Mapping[int, float | None]) -> None:
        here, self.point = self.point, _with(self.point, given)
        way = _only(_minus(here, self.point), given)
        turned = _turned(way, self.offsets.turns[system])
        self._set(system, _plus(self.offsets.systems[system], turned), self.offsets.turns[system])

    def _lay_other(self, system: int, given: Mapping[int, float | None]) -> None:
        turns = self._turn(self._active), self.offsets.turns[system]
        if turns != (0, 0):
            x, y, z = self.offsets.systems[system]
            self._set(system, (None, None, z), turns[1])
        there = _plus(self.point, self._system(self._active))
        x, y, z = (
            _difference(there[axis], given[axis]) if axis in given else each
            for axis, each in enumerate(self.offsets.systems[system])
        )
        if turns != (0, 0) and {0, 1} & given.keys():
            x = y = None
        self._set(system, (x, y, z), turns[1])

    def _set(self, system: int, origin: Point, turn: float | None) -> None:
        systems, turns = list(self.offsets.systems), list(self.offsets.turns)
        systems[system], turns[system] = origin, turn
        self.offsets = self.offsets._replace(systems=tuple(systems), turns=tuple(turns))

    def _shift(self, shift: Point) -> None:
        self.offsets = self.offsets._replace(shift=shift, kept=shift)

    def _system(self, number: int | None) -> Point:
        return _NOWHERE if number is None else self.offsets.systems[number]

    def _turn(self, number: int | None, sign: int = 1) -> float | None:
        turn = None if number is None else self.offsets.turns[number]
        return None if turn is None else sign * turn

    def _move(self, way: Point) -> None:
        self.point = _plus(self.point, way)

    def _lose(self) -> None:
        self.offsets, self.point = unknown(self._steady), _NOWHERE


def _given(line: Line, found: Words, state: State) -> dict[int, float | None]:
    """The axis words of a line; X may be a diameter."""
    said, share = values(line), share_of(found, state)
    given = {axis: said[letter] for axis, letter in enumerate(LINEAR) if letter in said}
    if given.get(0) is not None:
        x = given[0]
        given[0] = None if share is None or x is None else x * share
    return given


def _units(found: Words, state: State) -> str | None:
    return found.of("units") or ("" if state.untouched("units") else state.code("units"))


def _in_units(offsets: Offsets, unit: str | None) -> Offsets:
    """The same offsets in other units; where nobody knows how they relate, only zero is the same."""
    if unit == offsets.unit and unit is not None:
        return offsets
    factor = {("G20", "G21"): MM_PER_INCH, ("G21", "G20"): 1 / MM_PER_INCH}.get((offsets.unit or "", unit or ""))

    def scaled(point: Point) -> Point:
        x, y, z = (0.0 if each == 0 else None if each is None or factor is None else each * factor for each in point)
        return x, y, z

    # In other units the stand-alone interpreter mistakes the length of a tool, so that its answer and a machine's differ.
    x, y, z = (0.0 if each == 0 else None for each in offsets.tool)
    return Offsets(
        unit, tuple(map(scaled, offsets.systems)), offsets.turns, scaled(offsets.shift), scaled(offsets.kept), (x, y, z)
    )


def _certain(value: float, unit: str) -> float | None:
    return value if unit or not value else None


def _with(point: Point, given: Mapping[int, float | None]) -> Point:
    x, y, z = (given.get(axis, each) for axis, each in enumerate(point))
    return x, y, z


def _only(point: Point, given: Collection[int]) -> Point:
    """The axes that are given; along the others there is no way."""
    x, y, z = (each if axis in given else 0.0 for axis, each in enumerate(point))
    return x, y, z


def _turned(point: Point, degrees: float | None) -> Point:
    x, y, z = point
    if degrees == 0 or x == y == 0:
        return point
    if degrees is None or x is None or y is None:
        return None, None, z
    cos, sin = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return x * cos - y * sin, x * sin + y * cos, z


def _plus(one: Point, two: Point) -> Point:
    x, y, z = map(_sum, one, two)
    return x, y, z


def _minus(one: Point, two: Point) -> Point:
    """The way to one point from another; not known along an axis on which one of them is not."""
    x, y, z = map(_difference, one, two)
    return x, y, z


def _sum(one: float | None, two: float | None) -> float | None:
    return None if one is None or two is None else one + two


def _difference(one: float | None, two: float | None) -> float | None:
    return None if one is None or two is None else one - two
