"""Lines without values and flow: copied as they stand, a whole stretch at once, without a closure for each. Calculates nothing."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand.rs274.shapes import fixed, is_plain
from deburr_grammar.line import shapes_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.line import Shape

_NUMBER = re.compile(r"(?m)^[ \t]*[nN][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?")
SHORT = 64
"""A stretch of fewer lines that is met again is compiled: it stands in a loop or a subprogram."""


class Stretch(NamedTuple):
    """Consecutive lines to copy: from which row on, as they stand in the source, with their shapes."""

    first: int
    lines: Sequence[str]
    shapes: Sequence[Shape]

    def part(self, start: int, end: int) -> Stretch:
        """Some of them."""
        return Stretch(self.first + start, self.lines[start:end], self.shapes[start:end])

    def bare(self) -> tuple[Sequence[str], Sequence[int], Sequence[Shape]]:
        """The lines without their numbers, their rows and their shapes. A line that was only a number is none."""
        rows: Sequence[int] = range(self.first, self.first + len(self.lines))
        numbered = {shape: bare for shape in set(self.shapes) if (bare := _bare(shape)) is not shape}
        if not numbered:
            return self.lines, rows, self.shapes
        texts = _NUMBER.sub("", "\n".join(self.lines)).split("\n")
        shapes = [numbered.get(shape, shape) for shape in self.shapes]
        if any(not shape.text.strip() for shape in numbered.values()):
            kept = [at for at, text in enumerate(texts) if text.strip() or not self.lines[at].strip()]
            return [texts[at] for at in kept], [rows[at] for at in kept], [shapes[at] for at in kept]
        return texts, rows, shapes


class Stretches:
    """The plain stretches of one file, found chunk by chunk."""

    def __init__(self, unit: Unit) -> None:
        self._unit = unit
        self._first = self._behind = 0
        self._lines: list[str] = []
        self._shapes: list[Shape] = []
        self._plain = b""
        self._shared = b""
        self._met: set[int] = set()

    def at(self, row: int) -> Stretch | None:
        """The stretch that starts in a row; None if the line there is to be run, or compiled because it runs again."""
        if not self._first <= row < self._behind:
            self._read(row)
        start = row - self._first
        if start >= len(self._plain) or not self._plain[start]:
            return None
        end = self._plain.find(0, start)
        end = len(self._plain) if end < 0 else end
        if row in self._met and end - start < SHORT:
            self._met.update(range(row, row + end - start))
            return None
        self._met.add(row)
        return Stretch(row, self._lines[start:end], self._shapes[start:end])

    def shared(self, row: int) -> tuple[str, Shape] | None:
        """The line of a row that was just asked for, if it is compiled with all others of its shape."""
        at = row - self._first
        return (self._lines[at], self._shapes[at]) if at < len(self._shared) and self._shared[at] else None

    def _read(self, row: int) -> None:
        piece = self._unit.document.piece(row)
        self._first, self._lines, self._shapes = piece.line, piece.chunk.lines, piece.chunk.shapes
        self._behind = self._first + len(self._shapes)
        plain, shared = [], []
        for reading, _, shapes in piece.read():
            distinct = set(shapes)
            plain.append(bytes(map({shape: is_plain(shape, reading) for shape in distinct}.__getitem__, shapes)))
            live = reading.start is not None
            shared.append(
                bytes(map({shape: live and fixed(shape) is not None for shape in distinct}.__getitem__, shapes))
            )
        self._plain, self._shared = b"".join(plain), b"".join(shared)
        if self._unit.faulty:
            self._plain = bytes(
                plain and self._first + at not in self._unit.faulty for at, plain in enumerate(self._plain)
            )


def without_number(text: str) -> str:
    """A line without its line number."""
    match = _NUMBER.match(text)
    return text[match.end() :] if match is not None else text


def _bare(shape: Shape) -> Shape:
    """The shape of a line without its number."""
    found = shape.memo.get("rs274 bare")
    if found is None:
        text = without_number(shape.text)
        found = shape.memo["rs274 bare"] = shape if text == shape.text else shapes_of(shape.dialect)[text]
    assert isinstance(found, type(shape))
    return found
