"""Where an RS274 program has moved to, in the active coordinate system. A coordinate that only the machine knows is None."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence, Set
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES, LINEAR, MACHINE_UNIT, Coordinates, minus, plus, times, turned
from deburr.expand.rs274.modes import GROUP_OF

if TYPE_CHECKING:
    from deburr.expand.rs274.machine import Machine

PROBE_SHORT = 0.254
"""By how many millimetres its made-up probe stops before its target."""
_MOVING = frozenset((*AXES, "@", "^"))
MOVELESS = frozenset((431, 432, 700, 710, 711, 712, 720, 721, 722))
"""Codes whose axis words lead nowhere: tool offsets, and cycles that follow a contour."""
CYCLES = frozenset((730, 810, 820, 830, 840, 850, 860, 870, 880, 890))
_PROBES = frozenset((382, 383, 384, 385))
AXIS_CODES = frozenset((100, 280, 300, 520, 920))
"""Codes that take the axis words of a block from its motion."""
DEPTH = {170: 2, 180: 1, 190: 0, 171: 8, 181: 7, 191: 6}
"""The axis that canned cycles drill along, by plane."""


class Position:
    """The present point in machine coordinates and the offsets between it and the program's, all in millimetres or degrees.

    Where the system in force is turned, the point and the offsets of system and tool are those in axes that are turned with it: so a
    coordinate of the program is always a difference along one axis. Stored systems and homes are in the machine's axes.
    """

    def __init__(self, machine: Machine, simulate: bool) -> None:
        self._machine = machine
        self._simulate = simulate
        self._at: Coordinates = [0.0] * 9
        self._systems: list[Coordinates] = [[0.0] * 9 for _ in range(9)]
        self._active = 0
        self._system: Coordinates = [0.0] * 9
        """The offset in force: what was stored for the active system when it was chosen or set by G10."""
        self._turns = [0.0] * 9
        """The rotation of each system, in degrees."""
        self._turn = 0.0
        """The one in force."""
        self._shift: Coordinates = [0.0] * 9
        """G92 and G52."""
        self._tool: Coordinates = [0.0] * 9
        self._tool_then: Coordinates = self._tool
        """The tool's offset at the last move, for all that the stand-alone interpreter's machine knows."""
        self._kept_shift: Coordinates = [0.0] * 9
        self._retract: float | None = None
        self._depth_level: float | None = None

    def stored(self, params: Sequence[float]) -> None:
        """Offsets that a parameter file brought."""
        for at in (*range(5221, 5390), *range(5211, 5220)):
            if params[at] and not is_turn(at):
                self.set_parameter(at, params[at])
        self._active = round(params[5220]) - 1 if 1 <= params[5220] <= 9 else 0
        self._turns = [params[first + 9] for first in range(5221, 5401, 20)]
        self._turn = self._turns[self._active]
        self._system = turned(self._systems[self._active], -self._turn)
        if params[5210]:
            self._shift = list(self._kept_shift)

    def values(self) -> tuple[object, ...]:
        """The point and the offsets, to be compared."""
        offsets = (self._system, self._shift, self._tool, self._kept_shift)
        turns = (list(self._turns), self._turn)
        return (list(self._at), *map(list, (*self._systems, *offsets)), *turns, self._retract, self._depth_level)

    def axis(self, axis: int) -> float | None:
        """A coordinate in the active system, in the unit that the program writes."""
        value = self._program(axis)
        # No number at all comes of a unit that is not known.
        return None if value is None or math.isnan(value) else value / self._unit(axis)

    def is_offset(self) -> float | None:
        """Whether a tool offset is in force that is none of zeros."""
        return None if None in self._tool else float(any(self._tool))

    def read_back(self) -> None:
        """The interpreter asks its machine where it is. The stand-alone one has not heard of tool offsets since its last move."""
        for axis in range(9):
            self._at[axis] = plus(self._at[axis], minus(self._tool[axis], self._tool_then[axis]))
        self._tool_then = self._tool

    def switch(self, factor: float) -> None:
        """Another unit, so many times as large: the stand-alone interpreter's machine takes the number of a tool's offset for one in that unit."""
        tool = [times(value, factor) if axis in LINEAR else value for axis, value in enumerate(self._tool)]
        for axis in range(9):
            self._at[axis] = plus(self._at[axis], minus(tool[axis], self._tool[axis]))
        self._tool = tool

    def lose(self) -> None:
        """The machine moves where the program cannot see."""
        self._at = [None] * 9

    def trace(self, words: dict[str, float]) -> None:
        """A line of a contour: whatever the distance mode, X and Z are the point to which it leads."""
        for axis in (0, 2):
            if AXES[axis] in words:
                self._at[axis] = plus(self._offset(axis), words[AXES[axis]] * self._unit(axis))

    def moved(self, words: Mapping[str, float]) -> None:
        """Straight moves in absolute mode: where their last words lead."""
        self._retract = self._depth_level = None
        if not _MOVING.isdisjoint(words):
            self._tool_then = self._tool
            self._at = [
                plus(self._offset(axis), words[letter] * self._unit(axis)) if letter in words else self._at[axis]
                for axis, letter in enumerate(AXES)
            ]

    def set_parameter(self, at: int, value: float) -> None:
        """An offset was stored by its number."""
        system, axis = divmod(at - 5221, 20)
        if 5211 <= at <= 5219:
            self._kept_shift[at - 5211] = self._from_machine(at - 5211, value)
        elif 0 <= system < 9 and axis < 9:
            self._systems[system][axis] = self._from_machine(axis, value)
        elif is_turn(at) and value:
            self._systems[system] = [None] * 9

    def take(self, codes: Set[tuple[str, int]], words: dict[str, float]) -> None:
        """A block: systems, offsets, then the move."""
        gs = {code for letter, code in codes if letter == "G"}
        for code in gs:
            if GROUP_OF.get(code) == "system":
                self._choose((540, 550, 560, 570, 580, 590, 591, 592, 593).index(code))
            elif GROUP_OF.get(code) == "length":
                self._length(code, words)
        if gs & {921, 922, 923}:
            self._unshift(gs)
        for code, first in ((281, 5161), (301, 5181)):
            if code in gs:
                for axis, value in enumerate(turned(self._at, self._turn)):
                    self._store(first, axis, value)
        if gs & AXIS_CODES:
            self._non_modal(gs, words)
        elif not gs & MOVELESS and not _MOVING.isdisjoint(words):
            self._move(self._machine.modes.g["motion"], 530 in gs, words)
        if self._machine.modes.g["motion"] not in CYCLES:
            self._retract = self._depth_level = None

    def _unit(self, axis: int) -> float:
        return self._machine.modes.unit if axis in LINEAR else 1.0

    def _program(self, axis: int) -> float | None:
        return minus(self._at[axis], self._offset(axis))

    def _offset(self, axis: int) -> float | None:
        return plus(plus(self._system[axis], self._shift[axis]), self._tool[axis])

    def _from_machine(self, axis: int, value: float) -> float | None:
        """A stored offset in millimetres: only a simulated machine has a unit that is known."""
        if math.isnan(value):
            return None
        if value == 0 or axis not in LINEAR:
            return value
        return value * MACHINE_UNIT if self._simulate else None

    def _store(self, first: int, axis: int, value: float | None) -> None:
        """Keep an offset as a parameter; no number at all is one that only the machine knows."""
        unit = MACHINE_UNIT if axis in LINEAR else 1.0
        self._machine.state.params[first + axis] = math.nan if value is None else value / unit

    def _choose(self, number: int) -> None:
        """Another system; to name the active one again changes nothing, whatever was stored for it meanwhile."""
        if number != self._active:
            self._active = number
            self._turn_to(number)
            self._machine.state.params[5220] = number + 1.0

    def _turn_to(self, number: int) -> None:
        """A system comes into force where it lies, with its rotation; the machine stands still."""
        way, self._turn = self._turn - self._turns[number], self._turns[number]
        self._system = turned(self._systems[number], -self._turn)
        self._at, self._tool, self._tool_then = (turned(each, way) for each in (self._at, self._tool, self._tool_then))

    def _length(self, code: int, words: dict[str, float]) -> None:
        if code == 490:
            self._tool = [0.0] * 9
        elif code == 431:
            tool = turned(self._tool, self._turn)
            tool = [words[a] * self._unit(i) if a in words else tool[i] for i, a in enumerate(AXES)]
            self._tool = turned(tool, -self._turn)
        else:
            offsets = self._machine.length_offset(round(words["H"]) if "H" in words else None)
            found: Coordinates = [None] * 9
            if offsets is not None:
                found = [self._from_machine(axis, value) for axis, value in enumerate(offsets)]
            found = turned(found, -self._turn)
            self._tool = found if code == 430 else [plus(a, b) for a, b in zip(self._tool, found)]

    def _unshift(self, gs: Set[int]) -> None:
        if 923 in gs:
            self._shift = list(self._kept_shift)
            self._shifted(True)
            return
        self._shift = [0.0] * 9
        self._shifted(False)
        if 921 in gs:
            self._kept_shift = [0.0] * 9
            for axis in range(9):
                self._store(5211, axis, 0.0)

    def _shifted(self, on: bool) -> None:
        self._machine.state.params[5210] = float(on)
        self._machine.modes.shifted = on

    def _non_modal(self, gs: Set[int], words: dict[str, float]) -> None:
        given = {axis: words[letter] * self._unit(axis) for axis, letter in enumerate(AXES) if letter in words}
        if 920 in gs or 520 in gs:
            self._shift_to(given, 920 in gs)
        elif 100 in gs:
            self._data(given, words)
        elif gs & {280, 300}:
            self._home(5161 if 280 in gs else 5181, given)

    def _shift_to(self, given: dict[int, float], to_here: bool) -> None:
        """G92 makes the present point the one that is written; G52 is the offset itself."""
        for axis, value in given.items():
            base = minus(minus(self._at[axis], self._system[axis]), self._tool[axis])
            self._shift[axis] = minus(base, value) if to_here else value
            self._store(5211, axis, self._shift[axis])
        self._kept_shift = list(self._shift)
        self._shifted(True)

    def _data(self, given: dict[int, float], words: dict[str, float]) -> None:
        kind, number = round(words.get("L", 0)), round(words.get("P", 0))
        if kind not in (2, 20):
            return
        index = number - 1 if number else self._active
        system, before = self._systems[index], self._turn
        if "R" in words:
            self._turns[index] = words["R"]
            self._machine.state.params[5230 + 20 * index] = words["R"]
        if kind == 2:
            system = [given.get(axis, value) for axis, value in enumerate(system)]
        elif index == self._active:
            here = [minus(minus(value, self._shift[axis]), self._tool[axis]) for axis, value in enumerate(self._at)]
            laid = [minus(at, given[axis]) if axis in given else self._system[axis] for axis, at in enumerate(here)]
            system = turned(laid, self._turn)
        else:
            system = self._laid(index, given)
        self._systems[index] = system
        changed = {*given, 0, 1} if kind == 20 and (self._turn or self._turns[index]) else given
        for axis in changed:
            self._store(5221 + 20 * index, axis, system[axis])
        if index == self._active:
            self._turn_to(index)
            # Where a system is turned by L2, the interpreter turns the place without G92.
            for axis, value in enumerate(turned(self._shift, before - self._turn)) if kind == 2 else ():
                self._at[axis] = plus(self._at[axis], minus(self._shift[axis], value))

    def _laid(self, index: int, given: dict[int, float]) -> Coordinates:
        """Where a system that is not in force must lie for the place to have these coordinates in it."""
        tip = turned([minus(value, self._tool[axis]) for axis, value in enumerate(self._at)], self._turn)
        turn, system = self._turns[index], self._systems[index]
        there = turned([minus(a, b) for a, b in zip(tip, system)], -turn)
        wanted = [minus(value, self._shift[axis]) for axis, value in enumerate(there)]
        wanted = [plus(given.get(axis, value), self._shift[axis]) for axis, value in enumerate(wanted)]
        laid = [minus(a, b) for a, b in zip(tip, turned(wanted, turn))]
        changed = {*given, 0, 1} if turn and not {0, 1}.isdisjoint(given) else given
        return [laid[axis] if axis in changed else value for axis, value in enumerate(system)]

    def _home(self, first: int, given: dict[int, float]) -> None:
        """Through the point that is written to the stored one: along the axes that are written, or all."""
        params = self._machine.state.params
        there = turned(self._at, self._turn)
        for axis in given or range(9):
            there[axis] = self._from_machine(axis, params[first + axis]) if self._simulate else None
        self._at = turned(there, -self._turn)
        self._tool_then = self._tool

    def _move(self, motion: int, in_machine: bool, words: dict[str, float]) -> None:
        if motion == 800:
            return
        modes = self._machine.modes
        if motion != 0 and modes.g["feed"] == 930:
            # The control makes a feed of the length of the move.
            modes.feed = math.nan
        target = self._targets(words, in_machine)
        if motion in _PROBES:
            # The stand-alone interpreter's machine starts from where it thinks that it is.
            self.read_back()
        self._tool_then = self._tool
        if motion in CYCLES:
            self._drill(target, words)
        elif motion in _PROBES:
            self._probe(target)
        elif motion != 331:
            self._at = target

    def _targets(self, words: dict[str, float], in_machine: bool) -> Coordinates:
        if in_machine:
            found = turned(self._at, self._turn)
            for axis, letter in enumerate(AXES):
                found[axis] = words[letter] * self._unit(axis) if letter in words else found[axis]
            return turned(found, -self._turn)
        found = list(self._at)
        absolute = self._machine.modes.g["distance"] == 900
        for axis, letter in enumerate(AXES):
            if letter in words:
                value = words[letter] * self._unit(axis)
                base = self._offset(axis) if absolute else self._at[axis]
                found[axis] = plus(base, value)
        return self._polar(found, words)

    def _polar(self, found: Coordinates, words: dict[str, float]) -> Coordinates:
        """`@` and `^` are a radius and an angle about the origin, or by how much both change."""
        if "@" not in words and "^" not in words:
            return found
        x, y = self._program(0), self._program(1)
        if x is None or y is None:
            found[0] = found[1] = None
            return found
        radius, angle = math.hypot(y, x), math.degrees(math.atan2(y, x))
        if self._machine.modes.g["distance"] == 910:
            radius, angle = radius + words.get("@", 0.0) * self._unit(0), angle + words.get("^", 0.0)
        else:
            radius = words["@"] * self._unit(0) if "@" in words else radius
            angle = words.get("^", angle)
        direction = math.radians(angle)
        found[0] = plus(radius * math.cos(direction), self._offset(0))
        found[1] = plus(radius * math.sin(direction), self._offset(1))
        return found

    def _drill(self, target: Coordinates, words: dict[str, float]) -> None:
        """A canned cycle ends above its last hole: at the R plane, or (G98) not below where it began."""
        modes = self._machine.modes
        depth = DEPTH.get(modes.g["plane"])
        if depth is None:
            self.lose()
            return
        absolute = modes.g["distance"] == 900
        # R and the level at which the cycle began are kept as numbers: other units or offsets do not change them.
        self._retract = words.get("R", self._retract)
        if self._depth_level is None:
            self._depth_level = self.axis(depth)
        times = max(round(words.get("L", 1)), 0)
        for axis in range(9):
            if axis != depth and AXES[axis] in words and times:
                step = minus(target[axis], self._at[axis])
                self._at[axis] = (
                    target[axis] if absolute else plus(self._at[axis], None if step is None else step * times)
                )
        if "@" in words or "^" in words:
            self._at[0], self._at[1] = target[0], target[1]
        clear = self._retract if absolute else plus(self._retract, self._depth_level)
        ends = (clear,) if modes.g["retract"] == 990 else (self._depth_level, clear)
        known = [end * self._unit(depth) for end in ends if end is not None]
        self._at[depth] = plus(max(known), self._offset(depth)) if len(known) == len(ends) else None

    def _probe(self, target: Coordinates) -> None:
        if not self._simulate or None in target or None in self._at:
            self.lose()
            self._machine.probed([0.0] * 9)
            return
        self._machine.probed([(value or 0.0) / self._unit(axis) for axis, value in enumerate(self._seen(target))])
        way = [(b or 0.0) - (a or 0.0) for a, b in zip(self._at, target)]
        length = math.dist(way[:3], [0, 0, 0])
        part = max(0.0, 1 - PROBE_SHORT / length) if length else 0.0
        self._at = [(a or 0.0) + step * part for a, step in zip(self._at, way)]

    def _seen(self, target: Coordinates) -> Coordinates:
        return [minus(value, self._offset(axis)) for axis, value in enumerate(target)]


def is_turn(at: int) -> bool:
    """Whether a parameter is the rotation of a system."""
    return 5221 <= at < 5401 and (at - 5221) % 20 == 9
