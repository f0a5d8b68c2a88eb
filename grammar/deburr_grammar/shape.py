"""Line text to shape: lines that differ only in digits and inert comments are parsed once. Never looks at a document.

A shape is a line with each run of digits written as one `0` and the bodies of inert
comments dropped, except for what the dialect protects. Lines of one shape have the same
terminals in the same order, so one parse serves them all; a line is then its shape plus
the columns at which the folded stretches end.
"""

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

_NOTHING = "(?!)"
_SEPARATOR = "\0"
_DIGITS = re.compile("[0-9]+")
_NUMBER = r"[ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?"
_MARKED = bytes(range(0x80, 0x100))
_RARE = 200
"""Comment signs are rare where so many characters come to one."""


@dataclass(frozen=True)
class Folding:
    """How a dialect's lines are folded.

    ``codes`` are letters whose numbers must stay as they are, with blanks and a point in them.
    ``protect`` matches digit-bearing text that must stay as it is (keywords, G and M numbers).
    ``inert`` matches a whole comment whose body means nothing; its groups capture what is
    kept, and the body follows the first of them. A comment whose body does mean something is
    matched and kept as a whole, or what looks like another comment inside it would be dropped.
    Neither may match a line end, nor may ``protect`` reach into a comment.
    """

    codes: str = ""
    protect: str = ""
    inert: str = ""
    signs: str = ""
    """Characters of which every inert comment holds one: lines without them are not searched (none given: all lines are)."""

    def fold(self, text: str) -> str:
        """The shapes of all lines of a text whose line endings are newlines."""
        if self.inert:
            text = self._without_comments(text)
        folded = None if self.protect else _fold_digits(text, self._classes)
        if folded is not None:
            return folded
        if _SEPARATOR in text:
            return self._protected_or_digits.sub(lambda match: match[1] or "0", text)
        pieces = self._protect.split(text)
        rest = _SEPARATOR.join(pieces[::2])
        folded = _fold_digits(rest, _PLAIN)
        pieces[::2] = (_DIGITS.sub("0", rest) if folded is None else folded).split(_SEPARATOR)
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

    def _stretches(self, line: str, match: re.Match[str]) -> Iterable[tuple[int, int, int]]:
        """What is folded of a match: from where, up to where, and how many characters are left of it."""
        if match["digits_"]:
            return ((match.start(), match.end(), 1),)
        return self._of_comment(line, match) if match["inert_"] else ()

    def _of_comment(self, line: str, match: re.Match[str]) -> Iterator[tuple[int, int, int]]:
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
    def _protected(self) -> str:
        codes = [f"[{self.codes}]{_NUMBER}"] if self.codes else []
        return "|".join([*codes, self.protect or _NOTHING])

    @cached_property
    def _protect(self) -> re.Pattern[str]:
        return re.compile(f"({self._protected})")

    @cached_property
    def _protected_or_digits(self) -> re.Pattern[str]:
        return re.compile(f"({self._protected})|[0-9]+")

    @cached_property
    def _classes(self) -> bytes:
        return _classes_of(self.codes)

    @cached_property
    def _foldable(self) -> re.Pattern[str]:
        return re.compile(f"(?P<inert_>{self.inert or _NOTHING})|(?P<protected_>{self._protected})|(?P<digits_>[0-9]+)")


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


def _classes_of(codes: str) -> bytes:
    """Of each character, in a bit each, whether it is a digit, the letter of a code, a blank, a point."""
    kinds = ((0x80, "0123456789"), (0x40, codes), (0x20, " \t"), (0x10, "."))
    return bytes(sum(bit for bit, chars in kinds if chr(byte) in chars) for byte in range(256))


_PLAIN = _classes_of("")


def _fold_digits(text: str, classes: bytes) -> str | None:
    """Each run of digits as one `0`, but for those right behind the letter of a code; None where one has blanks or a point.

    All characters of a text are looked at at once: as one long integer, in which a bit of each
    byte says what it is, shifted by a byte against itself. That is much faster than replacing
    runs, and this is where a large file's time goes.
    """
    if not text.isascii():
        return None
    raw = text.encode("ascii")
    said = int.from_bytes(raw.translate(classes), "little")
    top = _top_bits(len(raw))
    digits, blanks, points = said & top, said << 2 & top, said << 3 & top
    codes = (said << 1 & top) << 8
    kept = more = codes & digits
    while more := more << 8 & digits:
        kept |= more
    behind = kept << 8
    if codes & blanks or behind & points or (behind & blanks) << 8 & (digits | blanks | points):
        return None
    loose = digits ^ kept
    # A digit without its lower half is a `0`; what follows another one is marked, and dropped.
    folded = int.from_bytes(raw, "little") & ~((loose >> 7) * 0x0F) | loose & loose << 8
    return folded.to_bytes(len(raw), "little").translate(None, _MARKED).decode("ascii")


@lru_cache(maxsize=64)
def _top_bits(size: int) -> int:
    return int.from_bytes(b"\x80" * size, "little")
