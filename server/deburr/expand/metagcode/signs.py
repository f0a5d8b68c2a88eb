"""Two signs in front of a number, one of them filled in: text that no control reads as a number (spec/metagcode.md §5.2, §5.5). Changes nothing."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

TWO_SIGNS = re.compile(r"[+-][ \t]*[+-]")
"""What every such line holds."""
_WORD = re.compile(r"(?<![A-Za-z])[A-Za-z][ \t]*([+-][ \t]*[+-])[0-9.]*")
_OTHER = re.compile(r'[(;"=<\[!]')
"""Behind one of these a sign may be that of a text or of an expression."""


class Doubled(NamedTuple):
    """A reference in a line: which of them, and the word that it makes."""

    number: int
    word: str


def doubled(line: Sequence[str], values: Mapping[str, str]) -> Doubled | None:
    """The first reference of a line, given as text and names in turn, that makes a word with two signs."""
    text, ends = "", list[int]()
    for index, each in enumerate(line):
        text += values[each] if index & 1 else each
        ends.append(len(text))
    for match in _WORD.finditer(text):
        if _OTHER.search(text, 0, match.start()):
            return None
        for index in range(1, len(line), 2):
            # One of the signs must be filled in: what is written out is the program's own business.
            if match.start(1) < ends[index] and ends[index - 1] < min(match.end(1), ends[index]):
                return Doubled(index // 2, match[0])
    return None
