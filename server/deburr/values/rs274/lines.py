"""The lines of an RS274 program that decide what parameters hold: which they are is kept with each chunk. Never reads what no parameter can touch."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.dialects.rs274.outline import codes

if TYPE_CHECKING:
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import LineNode, Shape

_PARTS = frozenset(("param", "setting", "o_line", "PERCENT"))
_BY_NUMBER = re.compile(r"[Mm][ \t]*0*[ \t]*9[ \t]*[89](?![0-9])|[Gg][ \t]*0*[ \t]*7[ \t]*[0-2](?![0-9])")
_ABORTS = re.compile(r"\([ \t]*abort[ \t]*,", re.I)
_KEY = "rs274 values"
_MOST = 20_000
"""Lines that take part. Of a program with more nothing is said: it is a list of moves, made by a machine."""
_LINES, _VALUES = "lines that take part", "parameters"


class Taken(NamedTuple):
    """A line that takes part, with what it opens or closes. ``ends``: whether it ends the program."""

    row: int
    node: LineNode
    bracket: Bracket | None
    ends: bool


def taken(document: Document) -> list[Taken] | None:
    """The lines that take part, in order; None where calls by number lead who knows where, or where there are too many."""
    found: list[Taken] = []
    for piece in document.holding(_KEY, _marks, _LINES):
        lines = _of_piece(document, piece)
        if lines is None or len(found) > _MOST:
            return None
        found += [line._replace(row=line.row + piece.line) for line in lines]
    return found


def concerns(document: Document) -> bool:
    """Whether any line reads or sets a parameter."""
    return _VALUES in document.gathered(_KEY, _marks)


def _marks(piece: Piece) -> frozenset[str]:
    found = {_LINES for _ in _wanted(piece)}
    for reading, _, shapes in piece.read():
        if reading.start is not None and any("param" in shape.facts(reading).kinds for shape in set(shapes)):
            found.add(_VALUES)
    return frozenset(found)


def _wanted(piece: Piece) -> Iterator[tuple[int, list[Shape], set[Shape]]]:
    for reading, first, shapes in piece.read():
        wanted = {shape for shape in set(shapes) if reading.start is not None and _takes_part(shape, reading)}
        if wanted:
            yield first, shapes, wanted


def _takes_part(shape: Shape, reading: Reading) -> bool:
    facts = shape.facts(reading)
    if not facts.kinds.isdisjoint(_PARTS) or (facts.problems and "#" in shape.text):
        return True
    return shape.needs_depth or _BY_NUMBER.search(shape.text) is not None or aborts(shape.text)


def aborts(text: str) -> bool:
    """Whether a comment of a line may stop the program."""
    return _ABORTS.search(text) is not None


def _of_piece(document: Document, piece: Piece) -> list[Taken] | None:
    key = ("rs274 lines that take part", document.key(piece))
    if key not in piece.chunk.memo:
        brackets = dict(piece.outlined.brackets)
        lines = [
            Taken(at, node := piece.node(at), brackets.get(at), _ends(node))
            for first, shapes, wanted in _wanted(piece)
            for at in (at for at, shape in enumerate(shapes, first) if shape in wanted)
        ]
        by_number = any(_BY_NUMBER.search(line.node.shape.text) for line in lines)
        piece.chunk.memo[key] = None if by_number else lines
    found: list[Taken] | None = piece.chunk.memo[key]
    return found


def _ends(node: LineNode) -> bool:
    return "PERCENT" in node.kinds or (
        node.shape.needs_depth and not {"M2", "M30"}.isdisjoint(code for code, _ in codes(node))
    )
