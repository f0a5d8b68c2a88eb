"""What lies between a program's coordinates and the machine's: work systems, their rotation, G92 and G52, tool lengths. All in mm and degrees.

A point of the program is turned about the origin of its system: machine = turned(program + G92) + system, for the tip of the tool.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import LINEAR

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from deburr.motion.form import Form

SYSTEMS = (540, 550, 560, 570, 580, 590, 591, 592, 593)
"""Ten times the codes of work systems."""
_FIRST, _EACH, _SHIFT = 5221, 20, 5211
Coordinates = list[float]


class Offsets:
    """All of them, and which are in force."""

    def __init__(self, form: Form) -> None:
        self._unit = form.tool_unit
        self._systems: list[Coordinates] = [[0.0] * 9 for _ in SYSTEMS]
        self._turns = [0.0] * len(SYSTEMS)
        self._kept: Coordinates = [0.0] * 9
        self.active = 0
        self.shift: Coordinates = [0.0] * 9
        """G92 and G52, where they are in force."""
        self.tool: Coordinates = [0.0] * 9
        self._stale = True
        self._sums: Coordinates | None = None
        self.plain: tuple[float, float, float] | None = None
        """`straight` along X, Y and Z, where it is nothing along all others; asked for behind `straight`."""
        self.known = bool(form.stored)
        """Whether it is known where the work systems lie in the machine."""
        self._given = set[int]()
        """The systems of which the program says it."""
        for at, value in form.stored.items():
            self.stored(at, value)
        stored = form.stored.get(5220, 1)
        self.active = round(stored) - 1 if 1 <= stored <= len(SYSTEMS) else 0
        if form.stored.get(5210):
            self.shift = list(self._kept)
        self.choose(self.active)

    def stored(self, at: int, value: float) -> None:
        """A stored parameter is set; what is in force stays as it is."""
        number, axis = divmod(at - _FIRST, _EACH)
        self._given.add(number)
        if _SHIFT <= at < _SHIFT + 9:
            self._kept[at - _SHIFT] = self._mm(at - _SHIFT, value)
        elif 0 <= number < len(SYSTEMS) and axis < 9:
            self._systems[number][axis] = self._mm(axis, value)
        elif 0 <= number < len(SYSTEMS) and axis == 9:
            self._turns[number] = value

    def home(self, first: int, stored: Mapping[int, float]) -> Coordinates:
        """A stored point of the machine, with zeros where none is stored."""
        return [self._mm(axis, stored.get(first + axis, 0.0)) for axis in range(9)]

    def choose(self, number: int) -> None:
        """A work system comes into force."""
        self._stale = True
        self.active = number
        self.system = list(self._systems[number])
        self._turn = self._turns[number]

    def set_system(self, number: int, given: Mapping[int, float], turn: float | None) -> None:
        """G10 L2: where a system lies. The one that is in force changes at once."""
        self._given.add(number)
        for axis, value in given.items():
            self._systems[number][axis] = value
        if turn is not None:
            self._turns[number] = turn
        if number == self.active:
            self.choose(number)

    def lay_system(self, number: int, given: Mapping[int, float], tip: Sequence[float]) -> None:
        """G10 L20: lay a system so that these are the coordinates of the tip in it."""
        wanted = list(self._back(tip, number))
        for axis, value in given.items():
            wanted[axis] = value
        turned = self._turned([a + b for a, b in zip(wanted, self.shift)], self._turns[number])
        self.set_system(number, {axis: tip[axis] - turned[axis] for axis in given}, None)

    def shift_to(self, given: Mapping[int, float], tip: Sequence[float]) -> None:
        """G92: make the tip have these coordinates."""
        self._stale = True
        for axis, value in given.items():
            self.shift[axis] += self.program(tip)[axis] - value
        self._kept = list(self.shift)

    def shift_by(self, given: Mapping[int, float]) -> None:
        """G52: these are the shift."""
        self._stale = True
        for axis, value in given.items():
            self.shift[axis] = value
        self._kept = list(self.shift)

    def unshift(self, forget: bool) -> None:
        """G92.1 and G92.2: no shift any more."""
        self._stale = True
        self.shift = [0.0] * 9
        if forget:
            self._kept = [0.0] * 9

    def reshift(self) -> None:
        """G92.3: the shift that was left."""
        self._stale = True
        self.shift = list(self._kept)

    @property
    def given(self) -> bool:
        """Whether anything says where the system lies that is in force."""
        return self.known or self.active in self._given

    @property
    def straight(self) -> Coordinates | None:
        """By how much the machine's coordinates exceed the program's; None if the system is turned."""
        if self._stale:
            self._stale = False
            self._sums = None if self._turn else [a + b for a, b in zip(self.shift, self.system)]
            still = self._sums is not None and not any(self._sums[3:])
            self.plain = (self._sums[0], self._sums[1], self._sums[2]) if still and self._sums else None
        return self._sums

    def machine(self, at: Sequence[float]) -> Coordinates:
        """The tip's place in the machine, of a point of the program."""
        found = self._turned([a + b for a, b in zip(at, self.shift)], self._turn)
        return [a + b for a, b in zip(found, self.system)]

    def program(self, tip: Sequence[float]) -> Coordinates:
        """The other way."""
        return self._back(tip, self.active)

    def turned(self, first: float, second: float) -> tuple[float, float]:
        """A point of the program in X and Y, in the machine."""
        found = self.machine([first, second, *[0.0] * 7])
        return found[0], found[1]

    def _back(self, tip: Sequence[float], number: int) -> Coordinates:
        found = [a - b for a, b in zip(tip, self._systems[number] if number != self.active else self.system)]
        return [a - b for a, b in zip(self._turned(found, -self._turns[number]), self.shift)]

    def _turned(self, point: Coordinates, turn: float) -> Coordinates:
        if not turn:
            return point
        angle = math.radians(turn)
        cos, sin = math.cos(angle), math.sin(angle)
        return [point[0] * cos - point[1] * sin, point[0] * sin + point[1] * cos, *point[2:]]

    def _mm(self, axis: int, value: float) -> float:
        return value * self._unit if axis in LINEAR else value
