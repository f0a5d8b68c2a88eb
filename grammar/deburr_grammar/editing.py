"""What an edit does to chunks: which lines it damaged, and what of the rest is kept. Never reads a line it need not."""

from __future__ import annotations

from array import array
from bisect import bisect_left
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from deburr_grammar.chunk import Branch, Chunk, Former, chunk_at, spliced
from deburr_grammar.line import Shape
from deburr_grammar.text import Pos, cut_points, line_starts, with_newlines


class Place(NamedTuple):
    """Where a chunk stands: its number, the number of its first line, the chunk."""

    number: int
    line: int
    chunk: Chunk


class _Region(NamedTuple):
    """Text that will become chunks; starts and shapes of its lines where they are known."""

    text: str
    starts: array[int] | None
    shapes: list[Shape] | None


class _Damage(NamedTuple):
    """The lines to read anew: from ``first`` of the left chunk to ``last`` of the right one, both included."""

    left: Chunk
    first: int
    right: Chunk
    last: int


def replaced(root: Branch, left: Place, right: Place, start: Pos, end: Pos, new: str, size: int) -> Branch:
    """The tree after the text from ``start`` (in ``left``) to ``end`` (in ``right``) became ``new``."""
    a = left.chunk.starts[start.line - left.line] + start.col
    b = right.chunk.starts[end.line - right.line] + end.col
    text = left.chunk.text[:a] + new + right.chunk.text[b:]
    first = start.line - left.line
    if text[a : a + 1] == "\n" and start.col == 0:
        # The line above may end with a carriage return, which this newline then joins.
        if a and text[a - 1] == "\r":
            first -= 1
        elif not a and left.number:
            chunk = chunk_at(root, left.number - 1)
            left = Place(left.number - 1, left.line - chunk.eols, chunk)
            text, first = chunk.text + text, chunk.eols - 1
    region = _patched(_Damage(left.chunk, first, right.chunk, end.line - right.line), text)
    stop = right.number + 1
    if len(text) < size // 4 and stop < root.chunks:
        region, stop = _joined(region, chunk_at(root, stop)), stop + 1
    table = left.chunk.table
    chunks = [Chunk(r.text, table, r.starts, r.shapes) for r in _cut(region, size)]
    if len(chunks) == 1 and left.chunk is right.chunk and stop == right.number + 1 and region.shapes is not None:
        chunks[0].former = Former(left.chunk.marked, left.chunk.memo, first, end.line - right.line)
    return spliced(root, left.number, stop, chunks)


def _patched(damage: _Damage, text: str) -> _Region:
    """The new text with what is known of its undamaged lines."""
    left, right = damage.left, damage.right
    above, below = left.known_shapes, right.known_shapes
    if above is None or below is None:
        return _Region(text, None, None)
    top = left.starts[damage.first]
    kept = right.starts[damage.last + 1 :]
    bottom = len(text) - (right.chars - kept[0]) if kept else len(text)
    damaged = text[top:bottom]
    shapes = left.table.read(with_newlines(damaged))
    if not damaged or damaged[-1] in "\r\n":
        shapes.pop()
    starts = left.starts[: damage.first]
    starts.extend(top + start for start in line_starts(damaged))
    if kept:
        starts.pop()
        moved = bottom - kept[0]
        starts.extend([start + moved for start in kept])
    return _Region(text, starts, above[: damage.first] + shapes + below[damage.last + 1 :])


def _joined(region: _Region, behind: Chunk) -> _Region:
    text = region.text + behind.text
    if region.starts is None or region.shapes is None or behind.known_shapes is None:
        return _Region(text, None, None)
    starts = region.starts[:-1]
    starts.extend(start + len(region.text) for start in behind.starts)
    return _Region(text, starts, region.shapes + behind.known_shapes)


def _cut(region: _Region, size: int) -> Iterator[_Region]:
    """The region in pieces, if it has grown too large for one chunk."""
    if len(region.text) <= 2 * size:
        yield region
        return
    cuts = [0, *cut_points(region.text, size), len(region.text)]
    for a, b in pairwise(cuts):
        if region.starts is None or region.shapes is None:
            yield _Region(region.text[a:b], None, None)
            continue
        first = bisect_left(region.starts, a)
        last = bisect_left(region.starts, b, lo=first)
        # The last piece keeps its tail: a line that no line end closes starts before `b` and is no line start of the next piece.
        ends = last if b < len(region.text) or region.text[-1] in "\r\n" else last - 1
        starts = array("I", (start - a for start in region.starts[first : ends + 1]))
        yield _Region(region.text[a:b], starts, region.shapes[first:last])
