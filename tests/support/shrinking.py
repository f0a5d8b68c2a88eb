"""How little of a failing program is enough: lines and then words of its files are left out while it still fails. Knows no language, runs nothing itself."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

Case = dict[str, str]
"""The files of a program, and what each of its runs is given in files called `run 1`, `run 2`."""
_Piece = tuple[str, str]
_Holds = Callable[[Sequence[_Piece]], bool]
_WORDS = re.compile(r"\w+|\n|.")


def is_run(name: str) -> bool:
    """Whether a file of a case holds what a run is given."""
    return name.startswith("run ")


def shrunk(case: Case, fails: Callable[[Case], bool], steps: int) -> Case:
    """The least of a failing case that was found to fail in so many tries. The same every time."""
    left = steps

    def holds(pieces: Sequence[_Piece]) -> bool:
        nonlocal left
        left -= 1
        return left >= 0 and fails(_joined(pieces))

    lines = _without_pairs(_fewest(_lines(case), holds), holds)
    return _joined(_fewest(_words(_joined(lines)), holds))


def _fewest(pieces: list[_Piece], holds: _Holds) -> list[_Piece]:
    """Pieces of which none can be left out alone: larger and then smaller groups of neighbours go."""
    size = max(len(pieces) // 2, 1)
    while True:
        before, at = len(pieces), 0
        while at < len(pieces):
            fewer = pieces[:at] + pieces[at + size :]
            if holds(fewer):
                pieces = fewer
            else:
                at += max(size // 4, 1)
        if size == 1 and len(pieces) == before:
            return pieces
        size = max(size // 2, 1)


def _without_pairs(pieces: list[_Piece], holds: _Holds) -> list[_Piece]:
    """Pieces of which no two can be left out, as the first and the last line of a block: those that stand close together first."""
    apart = 1
    while apart < len(pieces):
        at = 0
        while at + apart < len(pieces):
            fewer = pieces[:at] + pieces[at + 1 : at + apart] + pieces[at + apart + 1 :]
            if holds(fewer):
                pieces = fewer
            else:
                at += 1
        apart += 1
    return pieces


def _lines(case: Case) -> list[_Piece]:
    return [(name, line) for name, text in case.items() for line in text.splitlines(keepends=True)]


def _words(case: Case) -> list[_Piece]:
    """Names without a suffix are no programs: what runs are given is made of whole lines."""
    return [(name, word) for name, line in _lines(case) for word in (_WORDS.findall(line) if "." in name else [line])]


def _joined(pieces: Sequence[_Piece]) -> Case:
    case: Case = {}
    for name, text in pieces:
        case[name] = case.get(name, "") + text
    return case
