"""A control that reads a flat program block by block and says what moves: the words of RS274 (spec/rs274.md §5), whoever wrote them.

What modes mean is what `expand/rs274/modes.py` knows. Positions are not taken from the expander's own
machine: that one gives up a coordinate once a tool's length is not known, and has neither arcs nor
the moves within cycles. What is not understood is noted and passed over; no line is a fault.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.modes import GROUP_OF, MM_PER_INCH, Modes
from deburr.expand.rs274.position import AXIS_CODES, CYCLES, MOVELESS
from deburr.motion.motions import Motions
from deburr.motion.mover import LENGTHS, Mover
from deburr.motion.offsets import SYSTEMS
from deburr.motion.path import Flag, Happening
from deburr.motion.words import all_of, number, plain

if TYPE_CHECKING:
    from collections.abc import Mapping

    from deburr.motion.form import Form
    from deburr.motion.offsets import Coordinates
    from deburr.motion.path import Recorder
    from deburr.motion.words import Said

_STRAIGHT = {"0": 0, "00": 0, "1": 10, "01": 10, "2": 20, "02": 20, "3": 30, "03": 30}
_EASY = frozenset("XYZIJKRF")
_KNOWN_G = frozenset((40, 530, 281, 301, 921, 922, 923, *AXIS_CODES))
_KNOWN_M = frozenset((*range(3), *range(3, 10), 19, 30, 48, 49, *range(50, 54), 60, 61, *range(62, 69), *range(70, 74)))
_LETTERS = frozenset((*AXES, *"@^GMNFSTIJKRPQLHDEO"))
_CONTOURS = frozenset((700, 710, 711, 712, 720, 721, 722))
"""Cycles along a contour, in passes that only the control knows."""
_SAVES = frozenset((700, 720, 730))
_UNITS = {700: MM_PER_INCH, 710: 1.0}
"""Inches and millimetres in ISO 6983."""
_STOPS = {0: 0.0, 10: 1.0, 600: 60.0}
_ENDS = {20: 2.0, 300: 30.0}


class Machine:
    """One control, which writes down what it does."""

    def __init__(self, form: Form, recorder: Recorder) -> None:
        self._form = form
        self._recorder = recorder
        self._modes = Modes()
        self._stored = dict(form.stored)
        if form.unit != 1.0:
            self._modes.g["units"] = 200
        if form.arc_absolute:
            self._modes.g["arc"] = 901
        if form.diameter:
            self._modes.g["lathe"] = 70
        self._mover = Mover(form, self._modes, recorder)
        self._motions = Motions(self._modes, self._mover, recorder, form.simulate)
        self._selected = self._loaded = 0
        self._easy = self._is_easy()
        self._unmeasured = 0
        """The tool of which the length counts as zero, since nothing gives it."""
        self._count_zeros()
        self.ended = False
        self._saved: Modes | None = None
        """What M70 or M73 saved."""

    def line(self, text: str, flat: int) -> None:
        """A line of the flat program (0-based)."""
        found = plain(text)
        if found is None or not self._easy or not self._easily(found, flat):
            self._any(text, flat)

    def _easily(self, found: Said, flat: int) -> bool:
        """Straight moves and arcs in absolute coordinates of a system that is not turned; whether it was one."""
        motion, named, words = self._modes.g["motion"], False, dict[str, float]()
        for letter, said in found:
            if letter in _EASY:
                if letter in words:
                    return False
                words[letter] = number(said)
            elif letter == "G" and said in _STRAIGHT and not named:
                motion, named = _STRAIGHT[said], True
            elif letter != "N":
                return False
        if motion > 30:
            return False
        self._modes.g["motion"] = motion
        mover, unit = self._mover, self._modes.unit
        if "F" in words:
            self._modes.feed = words["F"]
            mover.feed = words["F"] * unit
        if motion >= 20 or words.keys().isdisjoint("XYZ"):
            self._motions.move(words, flat, named)
            return True
        mover.left_cycles()
        x, y, z = words.get("X"), words.get("Y"), words.get("Z")
        if unit != 1.0:
            x, y, z = (None if value is None else value * unit for value in (x, y, z))
        mover.line(motion // 10, x, y, z, flat)
        return True

    def _any(self, text: str, flat: int) -> None:
        said = all_of(text, self._stored)
        for at, value in said.settings:
            self._set(int(at), number(value))
        if said.rest:
            self._recorder.note(flat, f"`{said.rest[:40]}` is no word, and is passed over")
        codes, words = set[tuple[str, int]](), dict[str, float]()
        for letter, digits in said.words:
            if letter in "GM":
                codes.add((letter, round(number(digits) * 10)))
            elif letter in _LETTERS:
                words[letter] = number(digits)
                if self._form.step != 1.0 and letter in _SCALED and "." not in digits:
                    words[letter] *= self._form.step
            else:
                self._recorder.note(flat, f"words with {letter} are not followed")
        if codes or words:
            self._block(codes, words, flat)
        self._easy = self._is_easy()

    def _is_easy(self) -> bool:
        g = self._modes.g
        return (
            g["distance"] == 900
            and g["lathe"] == 80
            and g["feed"] != 930
            and self._form.step == 1.0
            and g["plane"] in (170, 180, 190)
        )

    def _set(self, at: int, value: float) -> None:
        self._stored[at] = value
        self._mover.offsets.stored(at, value)

    def _block(self, codes: set[tuple[str, int]], words: dict[str, float], flat: int) -> None:
        """All that a block does, in the order of spec/rs274.md §5."""
        modes, mover = self._modes, self._mover
        before = modes.copy()
        modes.take(codes, words)
        gs = {code for letter, code in codes if letter == "G"}
        ms = {code for letter, code in codes if letter == "M"}
        if ms & _SAVES:
            self._save(before.early(codes, words), ms, flat)
        if not self._form.contours and gs & _UNITS.keys() and words.keys().isdisjoint("PQ"):
            self._unsaid(gs & _UNITS.keys(), flat)
            gs -= _UNITS.keys()
        self._say_unknown(gs, ms, flat)
        if self._form.simulate and modes.unit != before.unit:
            mover.switch(modes.unit / before.unit)
        if "F" in words or modes.g["feed"] != before.g["feed"]:
            mover.feed = words.get("F", modes.feed) if modes.g["feed"] == 930 else modes.feed * modes.unit
        self._switched(before, words, ms, flat)
        if 40 in gs and "P" in words:
            self._recorder.event(flat, Happening.DWELL, words["P"])
        if modes.g["motion"] not in CYCLES:
            mover.left_cycles()
        self._offsets(gs, words, flat)
        if gs:
            self._count_zeros()
        self._flags()
        if gs & AXIS_CODES:
            self._non_modal(gs, words, flat)
        elif not gs & MOVELESS:
            self._motions.move(words, flat, any(GROUP_OF.get(code) == "motion" for code in gs), 530 in gs)
        elif gs & _CONTOURS:
            mover.lose((0, 2))
        if self._form.simulate and 60 in ms:
            mover.read_back()
        for code in ms & _STOPS.keys():
            self._recorder.event(flat, Happening.STOP, _STOPS[code])
        for code in ms & _ENDS.keys():
            self._recorder.event(flat, Happening.END, _ENDS[code])
            self.ended = True

    def _save(self, held: Modes, ms: set[int], flat: int) -> None:
        """Keep modes, or bring them back; a flat program has no words beside `M72` that the control would forget."""
        if 720 not in ms:
            self._saved = held
        elif self._saved is not None:
            for line in held.restoring(self._saved):
                self._any(line, flat)

    def _unsaid(self, gs: set[int], flat: int) -> None:
        """Codes that may set a unit. If it is the one that holds, they change nothing; if not, no length is certain behind them."""
        for code in sorted(gs):
            if _UNITS[code] != self._modes.unit:
                self._mover.unmeasured()
                self._recorder.note(
                    flat,
                    f"G{code // 10} may set the unit; nothing says so for certain, and lengths behind it are not held against limits",
                )

    def _count_zeros(self) -> None:
        self._recorder.zero(not self._mover.offsets.given, self._unmeasured)

    def _say_unknown(self, gs: set[int], ms: set[int], flat: int) -> None:
        for code in sorted((gs - GROUP_OF.keys() - _KNOWN_G) | gs & _CONTOURS):
            self._recorder.note(flat, f"G{code / 10:g} is not followed")
        for code in sorted(ms):
            if code // 10 not in _KNOWN_M:
                self._recorder.note(flat, f"M{code / 10:g} is not followed")

    def _switched(self, before: Modes, words: Mapping[str, float], ms: set[int], flat: int) -> None:
        """What else is on now than before."""
        modes, event = self._modes, self._recorder.event
        if "T" in words:
            self._selected = round(words["T"])
        if 60 in ms or 610 in ms:
            self._loaded = round(words.get("Q", 0)) if 610 in ms else self._selected
            event(flat, Happening.TOOL, self._loaded)
        if (modes.spindle, modes.speed) != (before.spindle, before.speed):
            event(flat, Happening.SPINDLE, modes.speed * {30: 1.0, 40: -1.0}.get(modes.spindle, 0.0))
        coolant = modes.mist + 2 * modes.flood
        if coolant != before.mist + 2 * before.flood:
            event(flat, Happening.COOLANT, coolant)
        if modes.g["units"] != before.g["units"]:
            event(flat, Happening.UNITS, modes.unit)
        if modes.g["plane"] != before.g["plane"]:
            event(flat, Happening.PLANE, modes.g["plane"] // 10)
        if modes.g["compensation"] != before.g["compensation"]:
            event(flat, Happening.COMPENSATION, modes.g["compensation"] // 10)

    def _flags(self) -> None:
        modes, flags = self._modes, 0
        if modes.spindle in (30, 40):
            flags |= Flag.SPINDLE
        if modes.g["compensation"] != 400:
            flags |= Flag.COMPENSATED
        if modes.g["feed"] != 940:
            flags |= Flag.INVERSE if modes.g["feed"] == 930 else Flag.PER_REVOLUTION
        self._mover.flags = int(flags)

    def _offsets(self, gs: set[int], words: Mapping[str, float], flat: int) -> None:
        """Tool lengths and work systems."""
        mover, offsets = self._mover, self._mover.offsets
        if 490 in gs:
            self._unmeasured = 0
            mover.jumped([0.0] * 9, flat)
        for code in gs & {430, 431, 432}:
            mover.jumped(self._length(code, words, flat), flat)
        for code in gs & set(SYSTEMS):
            number = SYSTEMS.index(code)
            if number != offsets.active:
                tip = offsets.machine(mover.at)
                offsets.choose(number)
                mover.stay(tip)
                self._recorder.event(flat, Happening.SYSTEM, number + 1)
        if gs & {921, 922, 923}:
            tip = offsets.machine(mover.at)
            if 923 in gs:
                offsets.reshift()
            else:
                offsets.unshift(921 in gs)
                mover.shifted(None)
            mover.stay(tip)
            self._recorder.event(flat, Happening.SHIFTED, float(923 in gs))

    def _length(self, code: int, words: Mapping[str, float], flat: int) -> Coordinates:
        now = self._mover.offsets.tool
        if code == 431:
            self._unmeasured, unit = 0, self._modes.unit
            return [
                words[letter] * (unit if letter in LENGTHS else 1.0) if letter in words else now[axis]
                for axis, letter in enumerate(AXES)
            ]
        tool = round(words["H"]) if "H" in words else self._loaded
        said = self._form.tools.get(tool)
        self._unmeasured = tool if said is None else 0
        if self._unmeasured:
            self._recorder.note(flat, f"the length of tool {tool} is not known, and counts as 0")
        found = [
            (said or {}).get(letter, 0.0) * (self._form.tool_unit if letter in LENGTHS else 1.0) for letter in AXES
        ]
        return found if code == 430 else [a + b for a, b in zip(now, found)]

    def _non_modal(self, gs: set[int], words: Mapping[str, float], flat: int) -> None:
        mover, offsets, given = self._mover, self._mover.offsets, self._motions.given(words)
        tip = offsets.machine(mover.at)
        if gs & {920, 520}:
            offsets.shift_to(given, tip) if 920 in gs else offsets.shift_by(given)
            mover.shifted(given if 920 in gs else None)
            mover.stay(tip)
            self._recorder.event(flat, Happening.SHIFTED, 1.0)
        elif 100 in gs:
            kind, at = round(words.get("L", 0)), round(words.get("P", 0)) - 1
            if kind in (2, 20) and at < len(SYSTEMS):
                at = at if at >= 0 else offsets.active
                if kind == 2:
                    offsets.set_system(at, given, words.get("R"))
                else:
                    offsets.lay_system(at, given, tip)
                    mover.laid(given)
                mover.stay(tip)
                self._recorder.event(flat, Happening.SYSTEM, at + 1)
                self._count_zeros()
            else:
                self._recorder.note(flat, f"G10 L{kind} is not followed")
        else:
            self._motions.home(5161 if 280 in gs else 5181, given, self._stored, flat)


_SCALED = LENGTHS | frozenset("IJKR")
