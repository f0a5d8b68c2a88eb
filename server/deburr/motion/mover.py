"""Makes moves of places: straight ones, arcs, canned cycles; and keeps where the tool is. Knows no words' order, no modes but those that it is told."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES, LINEAR
from deburr.expand.rs274.position import PROBE_SHORT
from deburr.motion import cycles
from deburr.motion.arcs import AXES_OF, centre_by_radius
from deburr.motion.offsets import Coordinates, Offsets
from deburr.motion.path import Flag, Happening, Kind

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from deburr.expand.rs274.modes import Modes
    from deburr.motion.form import Form
    from deburr.motion.path import Recorder

_XYZ = 0b111
_SIDEWAYS = int(Flag.SIDEWAYS)
"""Flags are whole numbers here: to join them as flags costs more than a move."""
ALL = (1 << len(AXES)) - 1
_SIGNS = {30: 1.0, 40: -1.0}

_OFF, _OFF_PART = 0.1, 0.01
"""Millimetres, and parts of the radius, by which an arc's end may be beside its circle before it is noted: controls differ."""


class Mover:
    """Where the tip of the tool is, and how it goes on. Lengths are in mm; ``flat`` is the line that moves."""

    def __init__(self, form: Form, modes: Modes, recorder: Recorder) -> None:
        self._recorder = recorder
        self._modes = modes
        self.offsets = Offsets(form)
        self.at: Coordinates = self.offsets.program([0.0] * 9)
        """In the program's coordinates: X, Y, Z, A, B, C, U, V, W."""
        self.flags = 0
        self.feed = 0.0
        self.unknown = 0 if form.simulate else ALL
        """Axes of which it is not said where they are, as `Path.unknown` has them."""
        self.lost = 0
        """Those of them that only the machine knows since it moved them."""
        self._then = self.offsets.tool
        """The tool's length at the last move, for all that the stand-alone interpreter's machine knows."""
        self.adrift = 0
        """Axes whose work offset is not known: it was made of a place that is not."""
        self._shifted = 0
        """Those whose G92 is not."""
        self._width = 3
        self._level: float | None = None
        """Where the first of a row of canned cycles began, along the drilled axis."""
        self._sticky: dict[str, float] = {}

    def go(self, kind: int, target: Coordinates, flat: int, flags: int = 0, pitch: float | None = None) -> None:
        """A straight move, or as an arc goes. ``pitch``: mm a revolution, in place of the feed."""
        start, self.at = self.at, target
        self._then = self.offsets.tool
        base = self.offsets.straight
        if self._width == 3 and (target[3:] != _STILL or (base or _MOVED)[3:] != _STILL):
            self._width = 9
        end = self.offsets.machine(target) if base is None else [a + b for a, b in zip(target[: self._width], base)]
        flags |= self.flags
        if self.lost:
            flags |= Flag.ASSUMED
        if start[0] != target[0] or start[1] != target[1]:
            flags |= _SIDEWAYS
        feed = self.feed
        if pitch is not None:
            feed, flags = pitch, flags & ~Flag.INVERSE | Flag.PER_REVOLUTION
        self._recorder.move(kind, flags, end[: self._width], flat, feed, self.unknown)

    def line(self, kind: int, x: float | None, y: float | None, z: float | None, flat: int) -> None:
        """A straight move to absolute places along X, Y and Z; None: that axis stays."""
        start = self.at
        target = [
            start[0] if x is None else x,
            start[1] if y is None else y,
            start[2] if z is None else z,
            *start[3:],
        ]
        if self.unknown & _XYZ:
            self.named(axis for axis, value in enumerate((x, y, z)) if value is not None)
        base = self.offsets.plain if self.offsets.straight is not None else None
        if base is None or self._width != 3 or self.lost:
            self.go(kind, target, flat)
            return
        self.at = target
        self._then = self.offsets.tool
        flags = self.flags
        if start[0] != target[0] or start[1] != target[1]:
            flags |= _SIDEWAYS
        end = (target[0] + base[0], target[1] + base[1], target[2] + base[2])
        self._recorder.move(kind, flags, end, flat, self.feed, self.unknown)

    def named(self, axes: Iterable[int]) -> None:
        """These axes are moved to places that the program says."""
        if self.unknown:
            said = sum(1 << axis for axis in axes)
            self.unknown &= ~said | self.adrift | self._shifted
            self.lost &= ~said

    def lose(self, axes: Iterable[int]) -> None:
        """These axes are moved to places that only the machine knows."""
        said = sum(1 << axis for axis in set(axes))
        self.unknown |= said
        self.lost |= said

    def unmeasured(self) -> None:
        """The unit of lengths is not certain any more, so that no word says where an axis goes."""
        self.lose(LINEAR)
        self.adrift |= sum(1 << axis for axis in LINEAR)

    def shifted(self, axes: Iterable[int] | None) -> None:
        """G92 is made of the places of these axes; None: it is gone."""
        self._shifted = self.unknown & sum(1 << axis for axis in axes) if axes is not None else 0

    def laid(self, axes: Iterable[int]) -> None:
        """A work system is made of the places of these axes."""
        self.adrift |= self.unknown & sum(1 << axis for axis in axes)

    def arc(self, target: Coordinates, plane: int, words: Mapping[str, float], clockwise: bool, flat: int) -> None:
        """An arc to a point. ``words``: I, J, K as distances from the start, R, in mm; P, the turns."""
        first, second, _ = AXES_OF[plane]
        start, end = (self.at[first], self.at[second]), (target[first], target[second])
        if "R" in words:
            centre = centre_by_radius(start, end, words["R"], clockwise)
        else:
            centre = (start[0] + words.get("IJK"[first], 0.0), start[1] + words.get("IJK"[second], 0.0))
        radius, beside = math.dist(start, centre), math.dist(end, centre)
        if abs(abs(words.get("R", radius)) - beside) > _OFF + _OFF_PART * radius:
            self._recorder.note(
                flat, f"no arc leads there: its end lies {beside:.6g} mm from its centre, its start {radius:.6g}"
            )
        if plane == 17:
            centre = self.offsets.turned(*centre)
        else:
            place = [0.0] * 9
            place[first], place[second] = centre
            found = self.offsets.machine(place)
            centre = (found[first], found[second])
        turns = max(round(words.get("P", 1.0)), 1)
        self.go(Kind.ARC, target, flat)
        self._recorder.arc(plane, centre, -turns if clockwise else turns)

    def jumped(self, tool: Coordinates, flat: int) -> None:
        """Another tool length: the machine stays, its tip is elsewhere."""
        if tool == self.offsets.tool:
            return
        tip = [a + b - c for a, b, c in zip(self.offsets.machine(self.at), self.offsets.tool, tool)]
        self.offsets.tool = tool
        self._recorder.length(flat, tool[:3])
        then = self._then
        self.go(Kind.SHIFT, self.offsets.program(tip), flat)
        self._then = then

    def read_back(self) -> None:
        """The stand-alone interpreter asks its machine where it is, which has not heard of tool lengths since it last moved."""
        tool = self.offsets.tool
        if self._then != tool:
            tip = self.offsets.machine(self.at)
            self.at = self.offsets.program([a + b - c for a, b, c in zip(tip, tool, self._then)])
            self._then = tool

    def switch(self, factor: float) -> None:
        """Its machine takes a tool's length for as many of the new unit, which is so many times as large."""
        self.offsets.tool = [
            value * factor if axis in LINEAR else value for axis, value in enumerate(self.offsets.tool)
        ]

    def stay(self, tip: Coordinates) -> None:
        """Offsets have changed: the same tip has other coordinates."""
        self.at = self.offsets.program(tip)

    def home(self, place: Coordinates, axes: Sequence[int], flat: int) -> None:
        """To a place in the machine along some axes."""
        target, there = self.at.copy(), self.offsets.program([a - b for a, b in zip(place, self.offsets.tool)])
        for axis in axes:
            target[axis] = there[axis]
        self.go(Kind.RAPID, target, flat)

    def in_machine(self, place: Coordinates, axes: Sequence[int]) -> Coordinates:
        """The point of the program where the machine is at a place, along some axes."""
        tip = self.offsets.machine(self.at)
        for axis in axes:
            tip[axis] = place[axis] - self.offsets.tool[axis]
        return self.offsets.program(tip)

    def polar(self, target: Coordinates, words: Mapping[str, float], unit: float, absolute: bool) -> None:
        """`@` and `^` are a radius and an angle about the origin, or by how much both change."""
        if "@" not in words and "^" not in words:
            return
        if not absolute:
            target[:2] = _turned((self.at[0], self.at[1]), words.get("@", 0.0) * unit, words.get("^", 0.0))
            return
        radius, angle = math.hypot(self.at[0], self.at[1]), math.degrees(math.atan2(self.at[1], self.at[0]))
        radius = words["@"] * unit if "@" in words else radius
        angle = math.radians(words.get("^", angle))
        target[:2] = radius * math.cos(angle), radius * math.sin(angle)

    def probe(self, target: Coordinates, flat: int, simulate: bool) -> None:
        """Towards a point. ``simulate``: as the stand-alone interpreter has it, it meets something just before."""
        if simulate:
            self.read_back()
        start = self.at
        self.go(Kind.PROBE, target, flat)
        self.lose(axis for axis in range(9) if start[axis] != target[axis])
        way = math.dist(start[:3], target[:3])
        if simulate and way:
            part = max(0.0, 1 - PROBE_SHORT / way)
            self.at = [a + (b - a) * part for a, b in zip(start, target)]

    def left_cycles(self) -> None:
        """Another motion than a canned cycle."""
        if self._level is not None:
            self._level = None
            self._sticky.clear()

    def drill(
        self,
        code: int,
        words: Mapping[str, float],
        given: Mapping[int, float],
        flat: int,
        turned: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """A canned cycle. ``words``: R, Q, I, J, K in mm, P in seconds, L; ``given``: the axes, absolute or in steps as the mode has it.

        ``turned``: by how much radius (mm) and angle (degrees) about the origin grow from hole to hole.
        """
        modes = self._modes
        first, second, across = AXES_OF[modes.g["plane"] // 10]
        absolute = modes.g["distance"] == 900
        if self._level is None:
            self._level = self.at[across]
        for letter in "RQPIJK":
            if letter in words:
                self._sticky[letter] = words[letter]
        self._sticky["depth"] = given.get(across, self._sticky.get("depth", 0.0))
        say = self._sticky.get
        level = self._level
        retract = say("R", level) if absolute else level + say("R", 0.0)
        bottom = say("depth", 0.0) if absolute else retract + say("depth", 0.0)
        begin = max(level, retract)
        levels = cycles.Levels(retract, bottom, retract if modes.g["retract"] == 990 else begin)
        speed = modes.speed * _SIGNS.get(modes.spindle, 0.0)
        aside = (say("IJK"[first], 0.0), say("IJK"[second], 0.0))
        middle = say("IJK"[across], 0.0) + (0.0 if absolute else bottom)
        said = cycles.Words(say("P", 0.0), say("Q", 0.0), aside, middle, speed)
        now = self.at[across]
        if level < retract:
            self._cycle_move(Kind.RAPID, (self.at[first], self.at[second], retract), flat)
            now = retract
        place = (self.at[first], self.at[second])
        for count in range(max(round(words.get("L", 1.0)), 0)):
            if absolute:
                place = (given.get(first, place[0]), given.get(second, place[1]))
            else:
                place = (place[0] + given.get(first, 0.0), place[1] + given.get(second, 0.0))
                place = _turned(place, *turned) if any(turned) else place
            height = now if count == 0 and now > retract else levels.clear
            self._cycle_move(Kind.RAPID, (*place, height), flat)
            if height > retract:
                self._cycle_move(Kind.RAPID, (*place, retract), flat)
            for step, value in cycles.hole(code, place, levels, said):
                if isinstance(step, Kind):
                    assert isinstance(value, tuple)
                    self._cycle_move(step, value, flat)
                else:
                    assert isinstance(value, float)
                    self._happens(step, value, flat)
        if code == 880:
            self.at[across] = levels.clear

    def _cycle_move(self, kind: Kind, point: tuple[float, float, float], flat: int) -> None:
        target = list(self.at)
        for axis, value in zip(AXES_OF[self._modes.g["plane"] // 10], point):
            target[axis] = value
        self.go(kind, target, flat, Flag.CYCLE)

    def _happens(self, what: Happening, value: float, flat: int) -> None:
        if what is Happening.SPINDLE:
            self.flags = self.flags | Flag.SPINDLE if value else self.flags & ~Flag.SPINDLE
        self._recorder.event(flat, what, value)


def _turned(place: tuple[float, float], radius: float, angle: float) -> tuple[float, float]:
    """A point further out by a radius, and turned about the origin by an angle in degrees."""
    out = math.hypot(*place) + radius
    way = math.atan2(place[1], place[0]) + math.radians(angle)
    return out * math.cos(way), out * math.sin(way)


_STILL = [0.0] * 6
_MOVED = [1.0] * 9
LENGTHS = frozenset(AXES[axis] for axis in LINEAR)
"""Letters of axes that are measured as lengths."""
