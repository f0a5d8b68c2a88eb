"""Line text to shape: lines that differ only in digits and inert comments are parsed once. Never looks at a document.

A shape is a line with each run of digits written as one `0` and the bodies of inert
comments dropped, except for what the dialect protects. Lines of one shape have the same
terminals in the same order, so one parse serves them all; a line is then its shape plus
the columns at which the folded stretches end.
"""

import re
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

_SEPARATOR = "\0"
_ZEROES = str.maketrans("123456789", "000000000")
_DIGITS = re.compile("[0-9]+")


@dataclass(frozen=True)
class Folding:
    """How a dialect's lines are folded.

    ``protect`` matches digit-bearing text that must stay as it is (keywords, G and M numbers).
    ``inert`` matches a whole comment whose body means nothing; its groups capture what is
    kept, and the body follows the first of them. Neither may match a line end, nor may
    ``protect`` reach into a comment.
    """

    protect: str = ""
    inert: str = ""

    def fold(self, text: str) -> str:
        """The shapes of all lines of a text whose line endings are newlines."""
        if self.inert:
            text = self._inert.sub(self._kept, text)
        if not self.protect:
            return _fold_digits(text)
        if _SEPARATOR in text:
            return self._protected_or_digits.sub(lambda match: match[1] or "0", text)
        pieces = self._protect.split(text)
        pieces[::2] = _fold_digits(_SEPARATOR.join(pieces[::2])).split(_SEPARATOR)
        return "".join(pieces)

    def columns(self, line: str) -> "Columns":
        """How the columns of a line's shape map to the columns of the line itself."""
        ends, growths, grown = [0], [0], 0
        for match in self._foldable.finditer(line):
            start, end = match.span()
            if match.lastgroup == "protected_":
                continue
            if match["digits_"]:
                behind, growth = start - grown + 1, end - start - 1
            else:
                kept = [group for group in match.groups()[1 : 1 + self._inert.groups] if group]
                behind, growth = start - grown + len(kept[0]), end - start - sum(map(len, kept))
            if growth:
                grown += growth
                ends.append(behind)
                growths.append(grown)
        return Columns(ends, growths)

    @cached_property
    def _inert(self) -> re.Pattern[str]:
        return re.compile(self.inert)

    @cached_property
    def _kept(self) -> str:
        return "".join(f"\\{group}" for group in range(1, self._inert.groups + 1))

    @cached_property
    def _protect(self) -> re.Pattern[str]:
        return re.compile(f"({self.protect})")

    @cached_property
    def _protected_or_digits(self) -> re.Pattern[str]:
        return re.compile(f"({self.protect})|[0-9]+")

    @cached_property
    def _foldable(self) -> re.Pattern[str]:
        nothing = r"(?!)"
        return re.compile(
            f"(?P<inert_>{self.inert or nothing})|(?P<protected_>{self.protect or nothing})|(?P<digits_>[0-9]+)"
        )


@dataclass(frozen=True, slots=True)
class Columns:
    """Behind each of ``ends`` (columns of a shape) the line has grown by that many characters."""

    ends: Sequence[int]
    growths: Sequence[int]

    def __call__(self, col: int) -> int:
        """The line's column for a column of its shape."""
        return col + self.growths[bisect_right(self.ends, col) - 1]


def _fold_digits(text: str) -> str:
    if not text.isascii():
        return _DIGITS.sub("0", text)
    text = text.translate(_ZEROES).replace("0000", "0").replace("000", "0")
    while "00" in text:
        text = text.replace("00", "0")
    return text
