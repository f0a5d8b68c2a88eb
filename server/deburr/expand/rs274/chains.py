"""Incremental moves whose values are rounded: what one leaves out the next makes up, so that a chain of them ends where it should. Knows no line."""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set

from deburr.expand.numbers import written
from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.modes import GROUP_OF, STRAIGHT, Modes
from deburr.expand.rs274.position import AXIS_CODES, CYCLES, DEPTH, MOVELESS

DECIMALS = 6
"""Of values that are written, if nothing else is asked for (spec/rs274.md §7)."""
_INCREMENTAL = 910
_ELSEWHERE = AXIS_CODES | MOVELESS | {530}
"""Codes whose axis words are no steps from the present point."""


class Chains:
    """What is left of each axis."""

    def __init__(self, modes: Modes, decimals: int) -> None:
        self._modes = modes
        self._decimals = decimals
        self._left: dict[str, float] = {}

    def clear(self, letters: Iterable[str]) -> None:
        """Absolute moves along these axes: whatever was left out is made up."""
        for letter in letters if self._left else ():
            self._left.pop(letter, None)

    def rounded(self, letters: Sequence[str], values: list[float], computed: Sequence[int]) -> list[float]:
        """The values of a line's words as they are to be written; ``computed`` are the numbers of the words that are rounded."""
        codes = {round(value * 10) for letter, value in zip(letters, values) if letter == "G"}
        motion, times = self._of("motion", codes), 1.0
        if self._of("distance", codes) != _INCREMENTAL or not codes.isdisjoint(_ELSEWHERE):
            return values
        steps = set(AXES)
        if motion in CYCLES:
            steps.discard(AXES[DEPTH.get(self._of("plane", codes), 2)])
            times = max(values[letters.index("L")] if "L" in letters else 1.0, 1.0)
        elif motion not in STRAIGHT:
            return values
        found = list(values)
        for at in computed:
            letter = letters[at]
            if letter in steps:
                wanted = values[at] + self._left.get(letter, 0.0) / times
                found[at] = float(written(wanted, self._decimals))
                self._left[letter] = (wanted - found[at]) * times
        return found

    def _of(self, group: str, codes: Set[int]) -> int:
        return next((code for code in codes if GROUP_OF.get(code) == group), self._modes.g[group])
