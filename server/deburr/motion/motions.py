"""The motions of a block: which words mean what in lines, arcs, splines, threads, cycles and ways home (spec/rs274.md §5). Never switches a mode."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.position import CYCLES
from deburr.motion import splines, threads
from deburr.motion.mover import LENGTHS
from deburr.motion.path import Flag, Kind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from deburr.expand.rs274.modes import Modes
    from deburr.motion.mover import Mover
    from deburr.motion.offsets import Coordinates
    from deburr.motion.path import Recorder

_AXIS = {letter: axis for axis, letter in enumerate(AXES)}
_PROBES = frozenset((382, 383, 384, 385))
_FORMS = frozenset("IJKR@^")


class Motions:
    """Makes moves of words under the modes that hold."""

    def __init__(self, modes: Modes, mover: Mover, recorder: Recorder, simulate: bool) -> None:
        self._modes = modes
        self._mover = mover
        self._recorder = recorder
        self._simulate = simulate

    def given(self, words: Mapping[str, float]) -> dict[int, float]:
        """The axis words, in mm or degrees."""
        unit, found = self._modes.unit, dict[int, float]()
        for letter, value in words.items():
            if letter in _AXIS:
                found[_AXIS[letter]] = value * unit if letter in LENGTHS else value
        if 0 in found and self._modes.g["lathe"] == 70:
            found[0] /= 2
        return found

    def home(self, first: int, given: Mapping[int, float], stored: Mapping[int, float], flat: int) -> None:
        """Through the point that is written to the stored one, along the axes that are written, or all."""
        mover = self._mover
        self._say(given)
        mover.go(Kind.RAPID, self._target(given), flat)
        axes = tuple(given) or tuple(range(9))
        if not any(first <= at < first + 9 for at in stored):
            mover.lose(axes)
            self._recorder.note(flat, "where the machine's stored point lies is not known; it is taken for its zero")
        mover.home(mover.offsets.home(first, stored), axes, flat)

    def _say(self, given: Mapping[int, float]) -> None:
        """The program says where these axes go, if not from where they are."""
        if self._modes.g["distance"] == 900:
            self._mover.named(given)

    def _target(self, given: Mapping[int, float]) -> Coordinates:
        target = self._mover.at.copy()
        absolute = self._modes.g["distance"] == 900
        for axis, value in given.items():
            target[axis] = value if absolute else target[axis] + value
        return target

    def move(self, words: Mapping[str, float], flat: int, named: bool, in_machine: bool = False) -> None:
        """The motion that is in force, if the block has something for it. ``named``: it says it itself."""
        modes, mover = self._modes, self._mover
        motion, given = modes.g["motion"], self.given(words)
        if motion == 800 or not (named or given or not _FORMS.isdisjoint(words)):
            return
        if motion in CYCLES:
            self._drill(motion, given, words, flat)
            return
        mover.left_cycles()
        if in_machine:
            if not mover.offsets.known:
                mover.lose(given)
            else:
                mover.named(given)
            place = [given.get(axis, 0.0) for axis in range(9)]
            mover.flags |= Flag.MACHINE
            self._run(motion, mover.in_machine(place, tuple(given)), words, flat)
            mover.flags &= ~Flag.MACHINE
            return
        self._say(given)
        target = self._target(given)
        mover.polar(target, words, modes.unit, modes.g["distance"] == 900)
        self._run(motion, target, words, flat)

    def _run(self, motion: int, target: Coordinates, words: Mapping[str, float], flat: int) -> None:
        mover, modes = self._mover, self._modes
        match motion:
            case 0 | 10:
                mover.go(Kind.FEED if motion else Kind.RAPID, target, flat)
            case 20 | 30:
                self._arc(target, words, motion == 20, flat)
            case 330 | 331:
                start, pitch = mover.at.copy(), words.get("K", 0.0) * modes.unit
                mover.go(Kind.THREAD, target, flat, pitch=pitch)
                if motion == 331:
                    mover.go(Kind.THREAD, start, flat, pitch=pitch)
            case _ if motion in _PROBES:
                mover.probe(target, flat, self._simulate)
                self._recorder.note(flat, "a probe ends where it meets something; it is shown as far as it may go")
            case 50 | 51:
                for point in splines.points(motion, mover.at, target, words, modes.unit):
                    mover.go(Kind.FEED, point, flat)
            case 760:
                self._thread(target, words, flat)
            case _:
                mover.go(Kind.FEED, target, flat)
                self._recorder.note(flat, f"G{motion / 10:g} is shown as a straight move")

    def _arc(self, target: Coordinates, words: Mapping[str, float], clockwise: bool, flat: int) -> None:
        modes, mover = self._modes, self._mover
        plane, unit = modes.g["plane"] // 10, modes.unit
        said = {letter: words[letter] * unit for letter in "IJKR" if letter in words}
        if modes.g["arc"] == 901:
            said |= {letter: said[letter] - mover.at[axis] for axis, letter in enumerate("IJK") if letter in said}
        if "P" in words:
            said["P"] = words["P"]
        if modes.g["plane"] % 10 or not said.keys() - {"P"}:
            mover.go(Kind.FEED, target, flat)
            why = "in a plane of U, V, W" if modes.g["plane"] % 10 else "without a centre or a radius"
            self._recorder.note(flat, f"an arc {why} is shown as a straight move")
            return
        mover.arc(target, plane, said, clockwise, flat)

    def _thread(self, target: Coordinates, words: Mapping[str, float], flat: int) -> None:
        mover, unit, say = self._mover, self._modes.unit, words.get
        across = unit / 2 if self._modes.g["lathe"] == 70 else unit
        thread = threads.Thread(
            (mover.at[0], mover.at[2]),
            target[2],
            say("I", 0.0) * across,
            say("J", 0.0) * across,
            say("K", 0.0) * across,
            say("R", 1.0),
            say("Q", 0.0),
            round(say("H", 0.0)),
            max(say("E", 0.0), 0.0) * unit,
            round(say("L", 0.0)),
        )
        if not thread.first:
            self._recorder.note(flat, "G76 without a first pass (J) is not followed")
            return
        for kind, x, z in threads.steps(thread):
            pitch = say("P", 0.0) * unit if kind is Kind.THREAD else None
            mover.go(kind, [x, mover.at[1], z, *mover.at[3:]], flat, Flag.CYCLE, pitch)

    def _drill(self, motion: int, given: Mapping[int, float], words: Mapping[str, float], flat: int) -> None:
        modes, mover = self._modes, self._mover
        if modes.g["plane"] % 10:
            self._recorder.note(flat, f"G{motion / 10:g} is not followed in a plane of U, V, W")
            return
        placed, turned = dict(given), (0.0, 0.0)
        if ("@" in words or "^" in words) and modes.g["distance"] == 900:
            target = mover.at.copy()
            mover.polar(target, words, modes.unit, True)
            placed |= {0: target[0], 1: target[1]}
        elif "@" in words or "^" in words:
            turned = (words.get("@", 0.0) * modes.unit, words.get("^", 0.0))
        said = {letter: words[letter] * modes.unit for letter in "RQIJK" if letter in words}
        said |= {letter: words[letter] for letter in "PL" if letter in words}
        self._say(given)
        mover.drill(motion, said, placed, flat, turned)
