"""What an RS274 control knows besides parameters: modes, position, offsets, tool. Follows the program until only the machine could know.

The stand-alone interpreter starts at zero, in millimetres, without a tool, in G54; so does
this. Values that come from outside (probes, inputs, homes, the machine's own unit) are refused
unless they are to be simulated; then they are what the stand-alone interpreter makes of them,
whose own unit is the inch (spec/rs274.md §4, spec/oracle.md §1, §3). Never emits anything.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.chains import DECIMALS, Chains
from deburr.expand.rs274.modes import GETTERS, STRAIGHT, UNKNOWN, Modes
from deburr.expand.rs274.position import Position, is_turn
from deburr.expand.rs274.tools import Tool, read_tools
from deburr_grammar.dialects.rs274.modality import code_of

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.source import Spot
    from deburr.expand.rs274.state import State
    from deburr.fault import Halt

Known = Callable[["Spot"], float]
"""What reads a predefined value: it is given the place, to be named if only the machine knows."""
_PROBED = range(5061, 5071)
_INPUT = 5399
_TOOL = range(5400, 5414)
_POSITION = range(5420, 5429)
_CHANGER = range(5600, 5602)
_OFFSETS = range(5161, 5391)
_ROUGHING = frozenset(("G", code) for code in (710, 711, 712, 720, 721, 722))
"""Cycles that end where only the control can say. One that finishes ends with its contour."""
_VERSION = 2.9
_OF_MACHINE = frozenset(("_current_pocket", "_selected_pocket", "_remap_level", "_task", "_vmajor", "_vminor"))
_OUTSIDE = ("_hal[", "_ini[", "_abs_")


class Machine:
    """One control."""

    state: State

    def __init__(self, job: Job) -> None:
        self._simulate = job.inputs.simulate
        self._tools = read_tools(job)
        self._foreign = frozenset(
            (code[0], round(float(code[1:]) * 10)) for code in map(code_of, job.settings["remap"])
        )
        """Codes to which the machine gives a meaning of its own."""
        self.modes = Modes()
        self.chains = Chains(self.modes, DECIMALS if job.inputs.decimals is None else job.inputs.decimals)
        self._position = Position(self, self._simulate)
        self._tool: Tool | None = Tool(0)
        """The tool in the spindle; None: only the machine knows."""
        self._selected: int | None = 0
        self._set: set[int] = set()
        """Parameters that the program set itself."""
        self.kept: list[int] = []
        """Parameters that were set and move later blocks: the flat program must set them, too."""
        self.special = frozenset((*_PROBED, _INPUT, *_TOOL, *_POSITION, *_CHANGER, *_OFFSETS))

    def started(self) -> None:
        """Stored parameters are there."""
        state = self.state
        if not state.params[5220]:
            state.params[5220] = 1.0
        state.params[5599] = 1.0
        self._position.stored(state.params)

    def values(self) -> tuple[object, ...]:
        """All that it holds, to be compared."""
        return (self._selected, self._tool, vars(self.modes.copy()), *self._position.values())

    def number(self, at: int, spot: Spot) -> float:
        """The value of a special parameter."""
        if at in _POSITION:
            if self.modes.g["compensation"] not in (400, UNKNOWN):
                message = f"the control does not tell `#{at}` while cutter compensation is on; it stops here"
                raise self._fault("in-compensation", spot, message)
            return self._known(self._position.axis(at - _POSITION[0]), f"#{at}", "the position", spot)
        if at in _TOOL:
            value = self._tool.value(at - _TOOL[0]) if self._tool is not None else None
            return self._known(value, f"#{at}", "the tool in the spindle", spot)
        if at in _OFFSETS:
            return self._offset(at, spot)
        if at in _CHANGER:
            return self._known(0.0 if self._simulate else None, f"#{at}", "the tool changer", spot)
        what = "the input" if at == _INPUT else "the probe"
        asked = at in self._set or self._simulate
        return self._known(self.state.params[at] if asked else None, f"#{at}", what, spot)

    def named(self, name: str) -> Known | None:
        """What reads a predefined name; None if it is none."""
        getter = GETTERS.get(name)
        if getter is not None:
            modes = self.modes
            what = "a move in inverse time or " if name == "_feed" else ""
            return lambda spot: self._known(getter(modes), f"#<{name}>", f"{what}a code of the machine's own", spot)
        axis = AXES.find(name[1:].upper()) if len(name) == 2 and name[0] == "_" else -1
        if axis >= 0:
            return lambda spot: self._known(self._position.axis(axis), f"#<{name}>", "the position", spot)
        own = self._own(name)
        if own is not None:
            return own
        if may_be_given(name):
            return lambda spot: self._outside(name, spot)
        return None

    def written(self, at: int) -> None:
        """A parameter was set by the program."""
        if at in self.special:
            self._set.add(at)
            if at in _OFFSETS:
                self._position.set_parameter(at, self.state.params[at])
                self.kept.append(at)

    @property
    def is_absolute(self) -> bool:
        """Whether axis words are places in the active system, as they are written."""
        return self.modes.g["distance"] == 900 and self.modes.g["lathe"] == 80 and self.state.contour is None

    @property
    def is_straight(self) -> bool:
        """Whether the motion in force leads along lines or arcs."""
        return self.modes.g["motion"] in STRAIGHT

    def moved(self, motion: int | None, words: dict[str, float]) -> None:
        """Absolute straight moves and arcs were executed, of which these are the last motion and words."""
        self.chains.clear(words)
        if motion is not None:
            self.modes.g["motion"] = motion
        if "F" in words:
            self.modes.feed = words["F"] if self.modes.g["feed"] != 930 else math.nan
        self.modes.speed = words.get("S", self.modes.speed)
        self._position.moved(words)

    def block(self, letters: Sequence[str], values: Sequence[float], maybe: bool) -> None:
        """A block with words was executed; ``maybe``: only if the operator's switch lets it."""
        if not letters:
            return
        words = {letter: value for letter, value in zip(letters, values) if letter not in "GM"}
        if "X" in words and self.modes.g["lathe"] == 70 and self.state.contour is not None:
            words["X"] /= 2
        codes = {(letter, round(value * 10)) for letter, value in zip(letters, values) if letter in "GM"}
        if not codes.isdisjoint(self._foreign):
            self.forget()
            return
        if self.state.contour is not None:
            self.modes.trace(codes)
            self._position.trace(words)
            return
        before = self.modes.unit
        self.modes.take(codes, words)
        if self.modes.g["distance"] == 900 or before != self.modes.unit:
            self.chains.clear(words if before == self.modes.unit else AXES)
        if self._simulate and before != self.modes.unit and not math.isnan(before):
            self._position.switch(self.modes.unit / before)
        if "X" in words and self.modes.g["lathe"] == 70:
            words["X"] /= 2
        if "T" in words:
            self._selected = round(words["T"])
        if ("M", 60) in codes:
            self._change(self._selected)
        elif ("M", 610) in codes and not self._simulate:
            self._change(round(words.get("Q", 0)))
        if ("M", 660) in codes:
            self.state.params[_INPUT] = 0.0
            self._set.discard(_INPUT)
        self._position.take(codes, words)
        if ("M", 60) in codes and self._simulate:
            self._position.read_back()
        elif ("M", 60) in codes:
            self._position.lose()
        if maybe or not codes.isdisjoint(_ROUGHING) or (("G", 700) in codes and words.get("E")):
            self._position.lose()

    def forget(self) -> None:
        """Something was done of which the program tells nothing."""
        self.modes.forget()
        self._position.lose()
        self._tool = self._selected = None

    def length_offset(self, tool: int | None) -> Sequence[float] | None:
        """The offsets of a tool in millimetres; None: only the machine knows. Without a number, of the tool in the spindle."""
        found = self._tool if tool is None else self._tools.get(tool)
        return None if found is None else found.offsets

    def probed(self, target: Sequence[float | None]) -> None:
        """A probe move ended; the stand-alone interpreter makes up that it met its target."""
        self._set.difference_update(_PROBED)
        for axis, value in enumerate(target):
            self.state.params[_PROBED[axis]] = value or 0.0
        self.state.params[_PROBED[9]] = 0.0

    def _change(self, tool: int | None) -> None:
        """Another tool is in the spindle. The stand-alone interpreter has no empty one, and knows nothing of M61."""
        if tool or not self._simulate:
            self._tool = self._tools.get(tool) if tool is not None else None

    def _own(self, name: str) -> Known | None:
        state = self.state
        match name:
            case "_value":
                return lambda spot: state.value
            case "_value_returned":
                return lambda spot: state.value_returned
            case "_call_level":
                return lambda spot: float(len(state.calls))
            case "_line":
                return lambda spot: float(spot.source.row + 1)
            case "_tool_offset":
                return lambda spot: self._known(self._position.is_offset(), "#<_tool_offset>", "the tool", spot)
            case "_selected_tool":
                return lambda spot: self._known(
                    self._selected, "#<_selected_tool>", "a code of the machine's own", spot
                )
            case "_current_tool":
                return lambda spot: self.number(_TOOL[0], spot)
            case _:
                return None

    def _offset(self, at: int, spot: Spot) -> float:
        """Offsets are kept in the machine's own unit, rotations in degrees; zero is the same in all."""
        value = self.state.params[at]
        if math.isnan(value):
            return self._known(None, f"#{at}", "the position", spot)
        if at in (5210, 5220) or is_turn(at) or value == 0 or at in self._set or self._simulate:
            return value
        return self._known(None, f"#{at}", "the unit of the machine", spot)

    def _known(self, value: float | None, said: str, what: str, spot: Spot) -> float:
        if value is None or math.isnan(value):
            message = f"`{said}` hangs on {what}, which only the machine knows here"
            raise self._fault("runtime-value", spot, message)
        return value

    def _fault(self, kind: str, spot: Spot, message: str) -> Halt:
        source, part = spot
        return self.state.fault(kind, source.file, source.row, source.span(part), message)

    def _outside(self, name: str, spot: Spot) -> float:
        given = self.state.globals.get(name)
        if given is not None:
            return given
        if self._simulate and name in _SIMULATED:
            return _SIMULATED[name]
        way = self.state.job.inputs.ways.define.format(f"{name}=...")
        message = f"`#<{name}>` hangs on the machine, which only the machine knows here; {way} gives it"
        raise self._fault("runtime-value", spot, message)


def may_be_given(name: str) -> bool:
    """Whether a predefined name is of what only the machine knows, unless a run is told; all others follow from the program."""
    return name in _OF_MACHINE or name.startswith(_OUTSIDE)


_SIMULATED = {"_task": 0.0, "_vmajor": _VERSION, "_vminor": 0.0, "_remap_level": 0.0}
