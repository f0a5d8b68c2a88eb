"""Line text to shape: lines that differ only in digits and inert comments are parsed once. Never looks at a document.

A shape is a line with each run of digits written as one `0` and the bodies of inert
comments dropped, except for what the dialect protects. Lines of one shape have the same
terminals in the same order, so one parse serves them all; a line is then its shape plus
the columns at which the folded stretches end.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

_SEPARATOR = "\0"
_NOTHING = "(?!)"
_DIGITS = re.compile("[0-9]+")
_ZEROES = bytes.maketrans(b"123456789", b"000000000")
_TOP_BIT = bytes(0x80 if byte in b"0123456789" else 0 for byte in range(256))
_MARKED = bytes(range(0x80, 0x100))
_RARE = 200
"""Comment signs are rare where so many characters come to one."""


@dataclass(frozen=True)
class Folding:
    """How a dialect's lines are folded.

    ``protect`` matches digit-bearing text that must stay as it is (keywords, G and M numbers).
    ``inert`` matches a whole comment whose body means nothing; its groups capture what is
    kept, and the body follows the first of them. A comment whose body does mean something is
    matched and kept as a whole, or what looks like another comment inside it would be dropped.
    Neither may match a line end, nor may ``protect`` reach into a comment.
    """

    protect: str = ""
    inert: str = ""
    signs: str = ""
    """Characters of which every inert comment holds one: lines without them are not searched (none given: all lines are)."""

    def fold(self, text: str) -> str:
        """The shapes of all lines of a text whose line endings are newlines."""
        if self.inert:
            text = self._without_comments(text)
        if not self.protect:
            return _fold_digits(text)
        if _SEPARATOR in text:
            return self._protected_or_digits.sub(lambda match: match[1] or "0", text)
        pieces = self._protect.split(text)
        pieces[::2] = _fold_digits(_SEPARATOR.join(pieces[::2])).split(_SEPARATOR)
        return "".join(pieces)

    def _without_comments(self, text: str) -> str:
        """Most lines of a large program have no comment, and to find a sign costs much less than to try a pattern everywhere."""
        if not self.signs or sum(map(text.count, self.signs)) > len(text) // _RARE:
            return self._inert.sub(self._kept, text)
        pieces, done = list[str](), 0
        for start in sorted({start for sign in self.signs for start in _lines_with(sign, text)}):
            end = text.find("\n", start)
            end = len(text) if end < 0 else end
            pieces += text[done:start], self._inert.sub(self._kept, text[start:end])
            done = end
        return "".join((*pieces, text[done:]))

    def columns(self, line: str) -> "Columns":
        """How the columns of a line's shape map to the columns of the line itself."""
        ends, growths, grown = [0], [0], 0
        for match in self._foldable.finditer(line):
            for start, end, left in self._stretches(line, match):
                if growth := end - start - left:
                    ends.append(start - grown + left)
                    grown += growth
                    growths.append(grown)
        return Columns(ends, growths)

    def _stretches(self, line: str, match: re.Match[str]) -> Iterator[tuple[int, int, int]]:
        """What is folded of a match: from where, up to where, and how many characters are left of it."""
        if match["digits_"]:
            yield *match.span(), 1
        elif match["inert_"]:
            kept = [match.span(group) for group in range(2, 2 + self._inert.groups) if match[group]]
            for number, (start, end) in enumerate(kept):
                # What is kept of a comment is folded like all other text.
                found = self._protected_or_digits.finditer(line, start, end)
                yield from ((*each.span(), 1) for each in found if not each[1])
                if not number:
                    yield end, match.end() - sum(b - a for a, b in kept[1:]), 0

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
        return re.compile(f"({self.protect or _NOTHING})|[0-9]+")

    @cached_property
    def _foldable(self) -> re.Pattern[str]:
        return re.compile(
            f"(?P<inert_>{self.inert or _NOTHING})|(?P<protected_>{self.protect or _NOTHING})|(?P<digits_>[0-9]+)"
        )


@dataclass(frozen=True, slots=True)
class Columns:
    """Behind each of ``ends`` (columns of a shape) the line has grown by that many characters."""

    ends: Sequence[int]
    growths: Sequence[int]

    def __call__(self, col: int) -> int:
        """The line's column for a column of its shape."""
        return col + self.growths[bisect_right(self.ends, col) - 1]

    def table(self, length: int) -> list[int]:
        """The line's columns for all columns of a shape of that length, its end included."""
        found: list[int] = []
        for start, end, growth in zip(self.ends, (*self.ends[1:], length + 1), self.growths):
            found += range(start + growth, end + growth)
        return found


def _lines_with(sign: str, text: str) -> Iterator[int]:
    """Where the lines start that hold a sign."""
    at = text.find(sign)
    while at >= 0:
        yield text.rfind("\n", 0, at) + 1
        end = text.find("\n", at)
        at = text.find(sign, end) if end >= 0 else -1


def _fold_digits(text: str) -> str:
    """Each run of digits as one `0`.

    All digits of a text are looked at at once: as one long integer, in which a byte's top bit
    says that it is a digit, shifted by a byte against itself. That is twice as fast as
    replacing runs, and this is where a large file's time goes.
    """
    if not text.isascii():
        return _DIGITS.sub("0", text)
    raw = text.encode("ascii")
    digits = int.from_bytes(raw.translate(_TOP_BIT), "little")
    behind_a_digit = digits & digits << 8
    marked = int.from_bytes(raw.translate(_ZEROES), "little") | behind_a_digit
    return marked.to_bytes(len(raw), "little").translate(None, _MARKED).decode("ascii")
