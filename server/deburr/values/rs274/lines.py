"""The lines of an RS274 program that decide what parameters hold: which they are is kept with each chunk. Never reads what no parameter can touch."""

from __future__ import annotations

import re
from collections.abc import Generator, Hashable, Iterator, Sequence
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.values.kept import LINES
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.rs274.outline import aborts, codes, computes_code, ends
from deburr_grammar.line import LineNode
from deburr_grammar.tree import Token

if TYPE_CHECKING:
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Shape

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


class Taken:
    """A line that takes part, with what it opens or closes. Where it stands is said beside it, so that equal lines are one object.

    ``ends``: whether it ends the program; ``returns``: whether its M99 may end what M98 called; ``enters``: the number of the program that
    its M98 calls, `UNSEEN` of a line that may call anything, empty of one that calls nothing so; ``is_start``: whether a program that M98 calls starts here.
    """

    __slots__ = ("bracket", "ends", "enters", "is_start", "memo", "node", "parts_here", "returns")

    def __init__(
        self,
        node: LineNode,
        bracket: Bracket | None,
        ends: bool = False,
        returns: bool = False,
        enters: str = "",
        is_start: bool = False,
    ) -> None:
        self.node = node
        self.bracket = bracket
        self.ends = ends
        self.returns = returns
        self.enters = enters
        self.is_start = is_start
        self.parts_here = is_start or (bracket is not None and bracket.role in (Role.REGION, Role.END_REGION))
        """Whether a routine starts or ends here."""
        self.memo: dict[Hashable, Any] = {}
        """Room for what is made of the line alone."""


class Several(NamedTuple):
    """Lines that take part, with the rows that they stand in."""

    rows: list[int]
    lines: list[Taken]


def taken(document: Document, remapped: Sequence[str] = ()) -> Generator[None, None, Several | None]:
    """The lines that take part, in order, found in steps; None where there are too many. ``remapped``: codes to which the machine gives a meaning of its own."""
    foreign = _written(tuple(remapped))
    found = Several([], [])
    marks = partial(_marks, foreign)
    several = 0
    for piece in document.holding((_KEY, foreign), marks, _LINES):
        # To read them costs much more than to count them.
        several += len(_wanted(piece, foreign))
        if several > _MOST:
            return None
        yield
    for piece in document.holding((_KEY, foreign), marks, _LINES):
        here, first = _of_piece(document, piece, foreign), piece.line
        found.rows.extend([row + first for row in here.rows])
        found.lines.extend(here.lines)
        yield
    return found


def concerns(document: Document) -> Generator[None, None, bool]:
    """Whether any line reads or sets a parameter."""
    yield from document.gathering((_KEY, None), partial(_marks, None))
    return _VALUES in document.gathered((_KEY, None), partial(_marks, None))


@lru_cache(8)
def _written(remapped: tuple[str, ...]) -> re.Pattern[str] | None:
    """What finds codes that are remapped, however they are written; rather too many than too few."""
    blanks = r"[ \t]*"
    names = [code.strip() for code in remapped if code.strip()]
    found = "|".join(rf"{code[0]}[ \t0]*{blanks.join(map(re.escape, code[1:]))}(?![0-9])" for code in names)
    return re.compile(found, re.I) if found else None


def _marks(foreign: re.Pattern[str] | None, piece: Piece) -> frozenset[str]:
    found = {_LINES} if _wanted(piece, foreign) else set()
    for reading, shape in piece.distinct():
        if reading.start is not None and "param" in shape.facts(reading).kinds:
            found.add(_VALUES)
    return frozenset(found)


def _wanted(piece: Piece, foreign: re.Pattern[str] | None) -> list[int]:
    """The lines of a piece that take part, counted from its first; kept with its chunk."""
    key = ("rs274 lines wanted", piece.outlined.runs, foreign)
    found: list[int] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = list(_found(piece, foreign))
    return found


def _found(piece: Piece, foreign: re.Pattern[str] | None) -> Iterator[int]:
    if foreign is None:
        yield from (at for at, _, _ in piece.where(lambda reading, shape: _takes_part(shape, reading)))
        return
    for reading, first, shapes in piece.read():
        for at, shape in enumerate(shapes, first) if reading.start is not None else ():
            if _takes_part(shape, reading) or foreign.search(piece.chunk.line(at)) is not None:
                yield at


def _takes_part(shape: Shape, reading: Reading) -> bool:
    if reading.start is None:
        return False
    facts = shape.facts(reading)
    if not facts.kinds.isdisjoint(_PARTS) or (facts.problems and "#" in shape.text):
        return True
    if shape.needs_depth or _BY_NUMBER.search(shape.text) is not None or aborts(shape.text):
        return True
    return not facts.kinds.isdisjoint(_CALCULATED) and computes_code(shape.text, shape.tree(reading))


def _of_piece(document: Document, piece: Piece, foreign: re.Pattern[str] | None) -> Several:
    key = ("rs274 lines that take part", document.key(piece), foreign)
    found: Several | None = piece.chunk.memo.get(key)
    if found is None:
        brackets, reading = dict(piece.outlined.brackets), piece.outlined.reading
        text, shapes, rows = piece.chunk.line, piece.chunk.shapes, _wanted(piece, foreign)
        lines = [_line(text(at), reading(at), shapes[at], brackets.get(at), foreign) for at in rows]
        found = piece.chunk.memo[key] = Several(rows, lines)
    return found


@lru_cache(maxsize=LINES)
def _line(text: str, reading: Reading, shape: Shape, bracket: Bracket | None, foreign: re.Pattern[str] | None) -> Taken:
    """A line: one that says the same as before is the same, so that what hangs on it need not be found again."""
    node = LineNode(text, reading, shape)
    if foreign is not None and foreign.search(node.text) is not None:
        return Taken(node, bracket, enters=UNSEEN)
    if "PERCENT" in node.kinds:
        return Taken(node, bracket, ends=True)
    if bracket is not None or "o_line" in node.kinds:
        is_start = bracket is None and not node.problems and "CALL" not in node.kinds
        return Taken(node, bracket, is_start=is_start)
    if not node.shape.needs_depth and _MAY_LEAVE.search(node.shape.text) is None:
        return Taken(node, bracket)
    found = {code for code, _ in codes(node)}
    return Taken(node, bracket, ends(found), "M99" in found, _entered(node, found))


def _entered(node: LineNode, found: set[str]) -> str:
    """What a line calls by a number."""
    words = [(node.text[word.start].upper(), word.children[1]) for word in node.find("word")]
    if "M98" not in found:
        is_computed = any(letter in "GM" and not isinstance(value, Token) for letter, value in words)
        return UNSEEN if is_computed or not found.isdisjoint(_CONTOURS) else ""
    said = [node.text[value.start : value.end].strip() for letter, value in words if letter == "P"]
    return str(int(said[0])) if len(said) == 1 and said[0].isdecimal() and len(said[0]) < 9 else UNSEEN
