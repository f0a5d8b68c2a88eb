"""Moves of a program as LinuxCNC's interpreter makes them, and as `deburr.motion` has them of its expansion. Never judges who is right."""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from deburr.formats.tools import read
from deburr.motion import Kind, Path, follow
from deburr.motion.arcs import AXES_OF
from deburr.motion.form import Form
from deburr.motion.path import Flag
from deburr.motion.splines import PIECES
from support.flat import Case

NEAR = 1e-4
"""In the unit of the program: it prints four decimals."""
_CALL = re.compile(r"([A-Z0-9_]+)\((.*)\)")
_UNITS = {"CANON_UNITS_MM": 1.0, "CANON_UNITS_INCHES": 25.4, "CANON_UNITS_CM": 10.0}
_PLANES = {"CANON_PLANE_XY": 17, "CANON_PLANE_XZ": 18, "CANON_PLANE_YZ": 19}
_KINDS = {"STRAIGHT_TRAVERSE": Kind.RAPID, "STRAIGHT_FEED": Kind.FEED, "STRAIGHT_PROBE": Kind.PROBE}
INCH = 25.4
"""The unit of the stand-alone interpreter's own machine."""


@dataclass(frozen=True)
class Seen:
    """A move: what it is, its end in mm in the machine, the turns and the centre of an arc, and how exactly the interpreter prints it, in mm."""

    kind: str
    end: tuple[float, ...]
    turns: int = 0
    centre: tuple[float, float] = (0.0, 0.0)
    near: float = 0.0

    def equals(self, other: "Seen") -> bool:
        """Whether another one is the same, as exactly as this one is printed."""
        here, there = (*self.end, *self.centre), (*other.end, *other.centre)
        same = (self.kind, self.turns) == (other.kind, other.turns)
        return same and all(abs(a - b) <= self.near for a, b in zip(here, there, strict=True))


@dataclass
class _Canon:
    """What the calls have set."""

    unit: float = 1.0
    plane: int = 17
    system: list[float] = field(default_factory=lambda: [0.0] * 6)
    shift: list[float] = field(default_factory=lambda: [0.0] * 6)
    turn: float = 0.0

    def place(self, point: Sequence[float]) -> tuple[float, ...]:
        x, y, *rest = (a + b for a, b in zip(point, self.shift))
        angle = math.radians(self.turn)
        turned = (x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle), *rest)
        moved = [a + b for a, b in zip(turned, self.system)]
        return tuple(value * self.unit if axis < 3 else value for axis, value in enumerate(moved))

    @property
    def near(self) -> float:
        """An offset is printed with four decimals, too."""
        shifts = sum(any(each) for each in (self.system, self.shift)) + bool(self.turn)
        return NEAR * (1 + shifts / 2) * self.unit


def canonical(calls: Sequence[str]) -> Iterator[Seen]:
    """The moves that the interpreter prints."""
    canon = _Canon()
    for call in calls:
        found = _CALL.fullmatch(call)
        if found is None:
            continue
        name, inside = found[1], [each.strip() for each in found[2].split(",")]
        if name == "USE_LENGTH_UNITS":
            factor = canon.unit / _UNITS[inside[0]]
            canon.unit = _UNITS[inside[0]]
            for offsets in (canon.system, canon.shift):
                offsets[:3] = [value * factor for value in offsets[:3]]
        elif name == "SELECT_PLANE":
            canon.plane = _PLANES.get(inside[0], 0)
        elif name == "SET_G5X_OFFSET":
            canon.system = [float(each) for each in inside[1:]]
        elif name == "SET_G92_OFFSET":
            canon.shift = [float(each) for each in inside]
        elif name == "SET_XY_ROTATION":
            canon.turn = float(inside[0])
        elif name in _KINDS:
            yield Seen(_KINDS[name].name, canon.place([float(each) for each in inside]), near=canon.near)
        elif name == "RIGID_TAP":
            point = [float(each) for each in inside]
            yield Seen("TAP", canon.place([*point, 0.0, 0.0, 0.0])[:3], near=canon.near)
        elif name == "NURBS_FEED":
            yield Seen("SPLINE", ())
        elif name == "ARC_FEED":
            yield _arc(canon, [float(each) for each in inside])


def _arc(canon: _Canon, said: Sequence[float]) -> Seen:
    first, second, across = AXES_OF[canon.plane]
    end, centre = [0.0] * 6, [0.0] * 6
    end[first], end[second], end[across], end[3:] = said[0], said[1], said[5], said[6:]
    centre[first], centre[second] = said[2], said[3]
    place = canon.place(centre)
    return Seen("ARC", canon.place(end), round(said[4]), (place[first], place[second]), canon.near)


def ours(path: Path) -> Iterator[Seen]:
    """The moves of a path as the interpreter would say them: of a spline it only says that there is one, of a tap where it ends."""
    found = [(move, _beside(path, index), path.arc(index)) for index, move in enumerate(path.moves())]
    index = 0
    while index < len(found):
        move, end, arc = found[index]
        after = found[index + 1][0] if index + 1 < len(found) else None
        if arc is not None:
            yield Seen("ARC", end, arc.turns, arc.centre)
        elif move.kind is Kind.THREAD:
            tapped = (
                after is not None
                and after.kind is Kind.THREAD
                and after.flat == move.flat
                and Flag.CYCLE not in move.flags
            )
            tapped = tapped and after is not None and after.end == path.before(index)
            yield Seen("TAP" if tapped else "FEED", move.end if tapped else end)
            index += tapped
        elif move.kind is Kind.FEED and len(path.of_line(move.flat)) == PIECES:
            yield Seen("SPLINE", ())
            index += PIECES - 1
        elif move.kind is not Kind.SHIFT:
            yield Seen(move.kind.name, end)
        index += 1


def _beside(path: Path, index: int) -> tuple[float, ...]:
    return (*path[index].end, *(path.beside[axis][index] if axis in path.beside else 0.0 for axis in "ABC"))


def path_of(case: Case) -> Path:
    """The path of a program's expansion, on the machine that the stand-alone interpreter is."""
    form = Form(tools=read(case.tools).words, tool_unit=INCH, simulate=True)
    return follow(case.expansion.lines, form)


def difference(case: Case) -> str:
    """How the moves differ; nothing if they do not."""
    plain = uncompensated(case) or case
    if plain.original.status != 0:
        return f"refused without compensation: {plain.original.message} {plain.original.echo}"
    theirs, mine = list(canonical(plain.original.calls)), list(ours(path_of(case)))
    for at, (one, two) in enumerate(zip(theirs, mine)):
        if not one.equals(two):
            return f"move {at}: {one} there, {two} here"
    return (
        ""
        if len(theirs) == len(mine)
        else f"{len(theirs)} moves there, {len(mine)} here; last {theirs[-1:]} {mine[-1:]}"
    )


_COMPENSATED = re.compile(r"(?i)G\s*4\s*[12](?:\.1)?(?![0-9.])")
_DIAMETER = re.compile(r"(?i)D\s*[-+]*[0-9.]+|L\s*[0-9]\s*$")


def uncompensated(case: Case) -> Case | None:
    """A program's expansion without cutter compensation; None if there is none in it."""
    lines = case.expansion.lines
    if not any(_COMPENSATED.search(line.partition("(")[0]) for line in lines):
        return None
    plain = [_DIAMETER.sub("", _COMPENSATED.sub("G40", line)) if _COMPENSATED.search(line) else line for line in lines]
    return Case(case.name, "".join(f"{line}\n" for line in plain), tools=case.tools)
