"""The modal state of an RS274 control as a program leaves it, and the predefined names that read it. Knows no position."""

from __future__ import annotations

import math
from collections.abc import Callable, Set
from copy import copy

_GROUPS = {
    "motion": (0, 10, 20, 30, 50, 51, 52, 53, 330, 331, 382, 383, 384, 385, 730, 760, *range(800, 900, 10)),
    "plane": (170, 171, 180, 181, 190, 191),
    "distance": (900, 910),
    "arc": (901, 911),
    "feed": (930, 940, 950),
    "units": (200, 210),
    "compensation": (400, 410, 411, 420, 421),
    "length": (430, 431, 432, 490),
    "retract": (980, 990),
    "system": (540, 550, 560, 570, 580, 590, 591, 592, 593),
    "path": (610, 611, 640),
    "spindle": (960, 970),
    "lathe": (70, 80),
}
"""Ten times each code, by its modal group."""
GROUP_OF = {code: group for group, codes in _GROUPS.items() for code in codes}

STRAIGHT = frozenset((0, 10, 20, 30))
"""Motion along lines and arcs."""
MM_PER_INCH = 25.4
UNKNOWN = -1
"""In place of a code: only the machine knows which is in force."""
EARLY = {
    ("G", 930): "", ("G", 940): "", ("G", 950): "", ("G", 960): "D", ("G", 970): "", ("M", 60): "", ("M", 610): "Q",
    ("M", 620): "P", ("M", 630): "P", ("M", 640): "P", ("M", 650): "P", ("M", 660): "PLQER", ("M", 670): "EQ",
    ("M", 680): "EQ",
}  # fmt: skip
"""Codes that act before M70 to M73 beside them, with the letters that they take (spec/rs274.md §5)."""
SETTING = "FST"
"""Letters that do so by themselves."""
_RESTORED = ("length", "plane", "system", "path", "lathe", "distance", "arc", "retract", "spindle", "compensation")
"""Groups whose code M72 says again where it differs."""


class Modes:
    """Ten times the code in force of each group, and what M codes switched."""

    def __init__(self) -> None:
        self.g = {
            "motion": 800, "plane": 170, "distance": 900, "arc": 911, "feed": 940, "units": 210,
            "compensation": 400, "length": 490, "retract": 990, "system": 540, "path": 640, "spindle": 970, "lathe": 80,
        }  # fmt: skip
        self.lost = False
        """Whether what M codes switched is not known."""
        self.feed = 0.0
        """No number: only the control knows."""
        self.speed = 0.0
        self.tolerance = (0.0, 0.0)
        """P and Q of G64."""
        self.spindle = 50
        self.mist = self.flood = False
        self.adaptive = False
        self.shifted = False
        """Whether G92 or G52 is in force."""
        self.feed_hold = self.feed_override = self.speed_override = True

    @property
    def unit(self) -> float:
        """Millimetres in the unit that lengths are written in; no number if it is not known."""
        if self.g["units"] == UNKNOWN:
            return math.nan
        return MM_PER_INCH if self.g["units"] == 200 else 1.0

    def forget(self) -> None:
        """Something was done of which the program tells nothing."""
        self.g = dict.fromkeys(self.g, UNKNOWN)
        self.feed = self.speed = math.nan
        self.lost = True

    def copy(self) -> Modes:
        """The same modes, to be kept."""
        found = copy(self)
        found.g = dict(self.g)
        return found

    def take(self, codes: Set[tuple[str, int]], words: dict[str, float]) -> None:
        """What the words of a block leave."""
        if ("M", 60) in codes:
            self.spindle = 50
        for letter, code in codes:
            if letter == "G" and code in GROUP_OF:
                self.g[GROUP_OF[code]] = code
            elif letter == "M":
                self._switch(code, words)
        if ("G", 640) in codes:
            self.tolerance = (words.get("P", 0.0), words.get("Q", 0.0))
        if ("G", 940) in codes or ("G", 950) in codes:
            self.feed = 0.0
        if self.g["feed"] != 930:
            # In inverse time the word says how long the move beside it takes.
            self.feed = words.get("F", self.feed)
        self.speed = words.get("S", self.speed)
        if ("M", 20) in codes or ("M", 300) in codes:
            self._ended()

    def early(self, codes: Set[tuple[str, int]], words: dict[str, float]) -> Modes:
        """What holds when M70 to M73 act in a block."""
        letters = {*SETTING, *(letter for code in codes for letter in EARLY.get(code, ""))}
        found = self.copy()
        found.take(codes & EARLY.keys(), {letter: value for letter, value in words.items() if letter in letters})
        return found

    def trace(self, codes: Set[tuple[str, int]]) -> None:
        """A line of a contour: of all modes only the motion is heeded."""
        self.g["motion"] = next((code for letter, code in codes if code in STRAIGHT), self.g["motion"])

    def restoring(self, saved: Modes) -> list[str]:
        """The lines that bring saved modes back as M72 does. It writes a feed with one decimal and a speed with none."""
        lines = [_code(saved.g["units"])] if self.g["units"] != saved.g["units"] else []
        words = []
        if self.g["feed"] != saved.g["feed"]:
            words.append(_code(saved.g["feed"]))
        if self.feed != saved.feed and not math.isnan(saved.feed):
            words.append(f"F{saved.feed:.1f}")
        if self.speed != saved.speed:
            words.append(f"S{saved.speed:.0f}")
        if self.spindle != saved.spindle:
            words.append(f"M{saved.spindle // 10}")
        words += [
            _code(saved.g[group])
            for group in _RESTORED
            if self.g[group] != saved.g[group] or (group == "path" and self.tolerance != saved.tolerance)
        ]
        if self.shifted != saved.shifted:
            words.append("G92.3" if saved.shifted else "G92.2")
        return [*lines, *([" ".join(words)] if words else []), *self._switching(saved)]

    def _switching(self, saved: Modes) -> list[str]:
        lines = []
        if (self.mist, self.flood) != (saved.mist, saved.flood):
            lines += [code for on, code in ((saved.mist, "M7"), (saved.flood, "M8")) if on] or ["M9"]
        if self.feed_override != saved.feed_override:
            lines.append("M48" if saved.feed_override else "M49")
        if saved.adaptive and not self.adaptive:
            # The control does not switch it off again.
            lines.append("M52")
        if self.feed_hold != saved.feed_hold:
            lines.append("M53" if saved.feed_hold else "M53 P0")
        return lines

    def _switch(self, code: int, words: dict[str, float]) -> None:
        on = words.get("P", 1.0) != 0
        match code:
            case 30 | 40 | 50:
                self.spindle = code
            case 70:
                self.mist = True
            case 80:
                self.flood = True
            case 90:
                self.mist = self.flood = False
            case 480 | 490:
                self.feed_override = self.speed_override = code == 480
            case 500:
                self.feed_override = on
            case 510:
                self.speed_override = on
            case 520:
                self.adaptive = on
            case 530:
                self.feed_hold = on
            case _:
                pass

    def _ended(self) -> None:
        """M2 and M30 bring back the first modes."""
        self.g.update(plane=170, distance=900, feed=940, compensation=400, system=540, motion=10)
        self.spindle, self.mist, self.flood = 50, False, False
        self.feed_override = self.speed_override = True


def _code(tenths: int) -> str:
    """A G code from ten times its number."""
    return f"G{tenths // 10}.{tenths % 10}" if tenths % 10 else f"G{tenths // 10}"


def _is(group: str, code: int) -> Callable[[Modes], float]:
    return lambda modes: float(modes.g[group] == code) if modes.g[group] != UNKNOWN else math.nan


def _of(group: str) -> Callable[[Modes], float]:
    return lambda modes: float(modes.g[group]) if modes.g[group] != UNKNOWN else math.nan


def _switched(switch: Callable[[Modes], bool]) -> Callable[[Modes], float]:
    return lambda modes: math.nan if modes.lost else float(switch(modes))


GETTERS: dict[str, Callable[[Modes], float]] = {
    "_absolute": _is("distance", 900),
    "_adaptive_feed": _switched(lambda modes: modes.adaptive),
    "_ccomp": _of("compensation"),
    "_coord_system": _of("system"),
    "_feed": lambda modes: modes.feed,
    "_feed_hold": _switched(lambda modes: modes.feed_hold),
    "_feed_override": _switched(lambda modes: modes.feed_override),
    "_flood": _switched(lambda modes: modes.flood),
    "_ijk_absolute_mode": _is("arc", 901),
    "_imperial": _is("units", 200),
    "_incremental": _is("distance", 910),
    "_inverse_time": _is("feed", 930),
    "_lathe_diameter_mode": _is("lathe", 70),
    "_lathe_radius_mode": _is("lathe", 80),
    "_metric": _is("units", 210),
    "_mist": _switched(lambda modes: modes.mist),
    "_motion_mode": _of("motion"),
    "_plane": _of("plane"),
    "_retract_old_z": _is("retract", 980),
    "_retract_r_plane": _is("retract", 990),
    "_rpm": lambda modes: modes.speed,
    "_speed_override": _switched(lambda modes: modes.speed_override),
    "_spindle_css_mode": _is("spindle", 960),
    "_spindle_cw": _switched(lambda modes: modes.spindle == 30),
    "_spindle_on": _switched(lambda modes: modes.spindle in (30, 40)),
    "_spindle_rpm_mode": _is("spindle", 970),
    "_units_per_minute": _is("feed", 940),
    "_units_per_rev": _is("feed", 950),
}
