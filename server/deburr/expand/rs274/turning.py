"""Arcs in R form: where a program has some, its coordinates are written with all their digits. Runs nothing.

Near a half circle the centre moves with the square root of what rounding leaves out: six decimals of a
length of 30 mm can move it by hundredths.
"""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING

from deburr.expand.rs274.axes import AXES
from deburr.expand.rs274.files import called_files
from deburr.expand.rs274.modes import GROUP_OF
from deburr.expand.rs274.words import codes_of
from deburr_grammar.dialects.rs274.outline import PROGRAM
from deburr_grammar.tree import Node, walk

if TYPE_CHECKING:
    from collections.abc import Callable, Generator

    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Shape

GEOMETRY = frozenset(f"{AXES}IJKR@^")
"""Letters of words that say where a move leads."""
_NO_ARCS = {"G10"} | {f"G{code / 10:g}" for code, group in GROUP_OF.items() if group == "motion"} - {"G2", "G3"}
_TURNS, _RADIUS, _BOTH = 1, 2, 3


def turns_by_radius(unit: Unit, load: Callable[[str], Unit | None]) -> Generator[None, None, bool]:
    """Whether a program with the files that it calls may have an arc in R form, found in steps. ``load`` brings the file of a label."""
    found = 0
    for file in called_files(unit, load):
        if file is None:
            found |= _BOTH
            continue
        for piece in file.document.pieces():
            found |= _of_piece(file.document, piece)
            yield
    return found == _BOTH


def _of_piece(document: Document, piece: Piece) -> int:
    """What the lines of a chunk have; kept with it, so that an edit leaves most of it known."""
    key = ("rs274 turns", document.key(piece))
    if key not in piece.chunk.memo:
        piece.chunk.memo[key] = reduce(or_, map(_of_shape, piece.chunk.distinct), 0)
    found: int = piece.chunk.memo[key]
    return found


def _of_shape(shape: Shape) -> int:
    """What lines of a shape have: `_TURNS`, `_RADIUS`; the code of an arc may stand on another line than its radius."""
    found = shape.memo.get("rs274 turns")
    if found is None:
        text, codes = shape.text, codes_of(shape)
        words = [part for part in walk(shape.tree(PROGRAM)) if isinstance(part, Node) and part.kind == "word"]
        letters = {text[word.start].upper() for word in words}
        computed = any(text[word.start] in "Gg" and isinstance(word.children[1], Node) for word in words)
        by_radius = "R" in letters and not letters.isdisjoint(AXES) and codes.isdisjoint(_NO_ARCS)
        turns = computed or not codes.isdisjoint(("G2", "G3"))
        found = shape.memo["rs274 turns"] = _TURNS * turns | _RADIUS * by_radius
    assert isinstance(found, int)
    return found
