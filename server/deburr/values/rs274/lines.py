"""The lines of an RS274 program that decide what parameters hold: which they are is kept with each chunk. Never reads what no parameter can touch."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator, Sequence
from functools import lru_cache, partial
from typing import TYPE_CHECKING, NamedTuple

from deburr.values.kept import line_of
from deburr_grammar.dialects.rs274.outline import aborts, codes, computes_code, ends
from deburr_grammar.tree import Token

if TYPE_CHECKING:
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import LineNode, Shape

UNSEEN = " "
"""The label of a call of which only the run knows where it leads. No label has a blank in it."""
_PARTS = frozenset(("param", "setting", "o_line", "PERCENT"))
_CALCULATED = frozenset(("group", "function"))
_BY_NUMBER = re.compile(r"[Mm][ \t]*0*[ \t]*9[ \t]*[89](?![0-9])|[Gg][ \t]*0*[ \t]*7[ \t]*[0-2](?![0-9])")
_MAY_LEAVE = re.compile(rf"{_BY_NUMBER.pattern}|[GgMm][ \t]*[\[#+-]")
"""Also codes of which only the run knows which they are."""
_CONTOURS = frozenset(("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"))
_KEY = "rs274 values"
_MOST = 20_000
"""Lines that take part. Of a program with more nothing is said: it is a list of moves, made by a machine."""
_LINES, _VALUES = "lines that take part", "parameters"


class Taken(NamedTuple):
    """A line that takes part, with what it opens or closes.

    ``ends``: whether it ends the program; ``returns``: whether its M99 may end what M98 called; ``enters``: the number of the program that
    its M98 calls, `UNSEEN` of a line that may call anything, empty of one that calls nothing so; ``is_start``: whether a program that M98 calls starts here.
    """

    row: int
    node: LineNode
    bracket: Bracket | None
    ends: bool = False
    returns: bool = False
    enters: str = ""
    is_start: bool = False


def taken(document: Document, remapped: Sequence[str] = ()) -> Generator[None, None, list[Taken] | None]:
    """The lines that take part, in order, found in steps; None where there are too many. ``remapped``: codes to which the machine gives a meaning of its own."""
    foreign = _written(tuple(remapped))
    found: list[Taken] = []
    marks = partial(_marks, foreign)
    several = 0
    for piece in document.holding((_KEY, foreign), marks, _LINES):
        several += _several(document, piece, foreign)
        if several > _MOST:
            return None
        yield
    for piece in document.holding((_KEY, foreign), marks, _LINES):
        found += [Taken(line.row + piece.line, *line[1:]) for line in _of_piece(document, piece, foreign)]
        yield
    return found


def concerns(document: Document) -> bool:
    """Whether any line reads or sets a parameter."""
    return _VALUES in document.gathered((_KEY, None), partial(_marks, None))


@lru_cache(8)
def _written(remapped: tuple[str, ...]) -> re.Pattern[str] | None:
    """What finds codes that are remapped, however they are written; rather too many than too few."""
    blanks = r"[ \t]*"
    names = [code.strip() for code in remapped if code.strip()]
    found = "|".join(rf"{code[0]}[ \t0]*{blanks.join(map(re.escape, code[1:]))}(?![0-9])" for code in names)
    return re.compile(found, re.I) if found else None


def _marks(foreign: re.Pattern[str] | None, piece: Piece) -> frozenset[str]:
    found = {_LINES for _ in _wanted(piece, foreign)}
    for reading, _, shapes in piece.read():
        if reading.start is not None and any("param" in shape.facts(reading).kinds for shape in set(shapes)):
            found.add(_VALUES)
    return frozenset(found)


def _wanted(piece: Piece, foreign: re.Pattern[str] | None) -> Iterator[int]:
    for reading, first, shapes in piece.read():
        if reading.start is None:
            continue
        wanted = {shape for shape in set(shapes) if _takes_part(shape, reading)}
        for at, shape in enumerate(shapes, first) if wanted or foreign else ():
            if shape in wanted or (foreign is not None and foreign.search(piece.chunk.line(at)) is not None):
                yield at


def _takes_part(shape: Shape, reading: Reading) -> bool:
    facts = shape.facts(reading)
    if not facts.kinds.isdisjoint(_PARTS) or (facts.problems and "#" in shape.text):
        return True
    if shape.needs_depth or _BY_NUMBER.search(shape.text) is not None or aborts(shape.text):
        return True
    return not facts.kinds.isdisjoint(_CALCULATED) and computes_code(shape.text, shape.tree(reading))


def _several(document: Document, piece: Piece, foreign: re.Pattern[str] | None) -> int:
    """How many lines of a piece take part: to read them costs much more."""
    key = ("rs274 lines that take part, counted", document.key(piece), foreign)
    if key not in piece.chunk.memo:
        piece.chunk.memo[key] = sum(1 for _ in _wanted(piece, foreign))
    found: int = piece.chunk.memo[key]
    return found


def _of_piece(document: Document, piece: Piece, foreign: re.Pattern[str] | None) -> list[Taken]:
    key = ("rs274 lines that take part", document.key(piece), foreign)
    if key not in piece.chunk.memo:
        brackets = dict(piece.outlined.brackets)
        piece.chunk.memo[key] = [
            _line(at, line_of(piece, at), brackets.get(at), foreign) for at in _wanted(piece, foreign)
        ]
    found: list[Taken] = piece.chunk.memo[key]
    return found


def _line(at: int, node: LineNode, bracket: Bracket | None, foreign: re.Pattern[str] | None) -> Taken:
    if foreign is not None and foreign.search(node.text) is not None:
        return Taken(at, node, bracket, enters=UNSEEN)
    if "PERCENT" in node.kinds:
        return Taken(at, node, bracket, ends=True)
    if bracket is not None or "o_line" in node.kinds:
        is_start = bracket is None and not node.problems and "CALL" not in node.kinds
        return Taken(at, node, bracket, is_start=is_start)
    if not node.shape.needs_depth and _MAY_LEAVE.search(node.shape.text) is None:
        return Taken(at, node, bracket)
    found = {code for code, _ in codes(node)}
    return Taken(at, node, bracket, ends(found), "M99" in found, _entered(node, found))


def _entered(node: LineNode, found: set[str]) -> str:
    """What a line calls by a number."""
    words = [(node.text[word.start].upper(), word.children[1]) for word in node.find("word")]
    if "M98" not in found:
        is_computed = any(letter in "GM" and not isinstance(value, Token) for letter, value in words)
        return UNSEEN if is_computed or not found.isdisjoint(_CONTOURS) else ""
    said = [node.text[value.start : value.end].strip() for letter, value in words if letter == "P"]
    return str(int(said[0])) if len(said) == 1 and said[0].isdecimal() and len(said[0]) < 9 else UNSEEN
