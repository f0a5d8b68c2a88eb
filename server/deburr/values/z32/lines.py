"""The lines of a Z32 file that decide what parameters hold, or where it goes on: which they are is kept with each chunk. Never reads what no parameter can touch."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.z32 import constant
from deburr.values.kept import LINES, line_of
from deburr_grammar.dialects.z32.forms import NUMBERED, number, section_number
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import LineNode, Shape

SYSTEM = ("LX", "AE")
"""Names of two letters that are no user's: like axes they stand in moves."""
_PARTS = frozenset(("advanced", "angle", "vector", "alias_name", "axis_alias", "G26", "M_END", "section"))
_CALCULATED = frozenset(("advanced", "angle", "vector"))
_NAMES = ("NAME", "other", "reserved")
_KEY = "z32 values"
_MOST = 8_000
"""Lines that take part. Of a program with more nothing is said: it is a list of moves, made by a machine."""
_LINES, _VALUES, _ALIAS_READ, _COMPUTED = "lines that take part", "parameters", "an alias is read", "a computed jump"


class Taken(NamedTuple):
    """A line that takes part: its row, its block number, the number of the section that it starts, whether it starts any, and the calls in it."""

    row: int
    node: LineNode
    label: float | None
    section: int | None
    titled: bool
    calls: Sequence[Node]


class Marks(NamedTuple):
    """What the lines of a file say together: the block numbers that jumps name, whether a jump computes one, the axis and system parameters that are read."""

    targets: frozenset[float]
    computed: bool
    reads: frozenset[str]


def concerns(document: Document) -> Generator[None, None, bool]:
    """Whether any line calculates, jumps or calls."""
    yield from document.gathering(_KEY, _marks)
    return _VALUES in document.gathered(_KEY, _marks)


def marks_of(document: Document) -> Marks:
    """What its lines say together."""
    found = document.gathered(_KEY, _marks)
    reads = {said[6:] for said in found if isinstance(said, str) and said.startswith("reads ")}
    if _ALIAS_READ in found:
        reads |= {said[6:] for said in found if isinstance(said, str) and said.startswith("alias ")}
    targets = frozenset(said for said in found if isinstance(said, float))
    return Marks(targets, _COMPUTED in found, frozenset(reads))


def taken(document: Document, tracked: frozenset[str], marks: Marks) -> Generator[None, None, list[Taken] | None]:
    """The lines that take part, in order, found in steps: those that calculate or turn, those to which jumps lead, and those that set one of ``tracked``. None: too many."""
    found: list[Taken] = []
    for piece in document.pieces():
        lines = _of_piece(document, piece, tracked, marks)
        found += lines
        if len(found) > _MOST:
            return None
        yield
    return found


def is_system(name: str) -> bool:
    """Whether a parameter is an axis's or the system's: each word of a move sets one."""
    return len(name) == 1 or name in SYSTEM


def _of_piece(document: Document, piece: Piece, tracked: frozenset[str], marks: Marks) -> Sequence[Taken]:
    labels = _labels(document, piece)
    wanted = frozenset(labels) if marks.computed else marks.targets.intersection(labels)
    key = ("z32 lines that take part", document.key(piece), tracked, wanted)
    known: tuple[int, list[Taken]] | None = piece.chunk.memo.get(key)
    if known is None:
        rows = set(_rows(piece, tracked)) | {at for value in wanted for at in labels[value]}
        known = 0, [_taken(piece, at) for at in sorted(rows)]
    first, found = known
    if first != piece.line:
        found = [line._replace(row=line.row + piece.line - first) for line in found]
    piece.chunk.memo[key] = piece.line, found
    return found


def _taken(piece: Piece, at: int) -> Taken:
    node = line_of(piece, at)
    return Taken(at, node, *_facts(node))


@lru_cache(maxsize=LINES)
def _facts(node: LineNode) -> tuple[float | None, int | None, bool, Sequence[Node]]:
    kinds = node.kinds
    match = NUMBERED.match(node.text) if "nword" in kinds else None
    titled = "section" in kinds
    section = section_number(node.text) if titled else None
    return number(match[2]) if match else None, section, titled, tuple(node.find("call", "file_call"))


@lru_cache(maxsize=LINES)
def _jumps(node: LineNode) -> frozenset[object]:
    """The block numbers that the jumps of a line name, and whether one is computed."""
    found: set[object] = set()
    for jump in node.find("jump"):
        end = jump.node("range_end")
        for part in (jump.children[1], *(end.children[1:] if end is not None else ())):
            value = constant(node.text, part)
            found.add(value if isinstance(value, float) else _COMPUTED)
    return frozenset(found)


def _labels(document: Document, piece: Piece) -> Mapping[float, list[int]]:
    """The indices of a chunk's lines by their block numbers."""
    key = ("z32 block numbers", document.key(piece))
    found: dict[float, list[int]] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = {}
        for at, _, _ in piece.where(lambda reading, shape: _is_read(reading) and "nword" in shape.facts(reading).kinds):
            if match := NUMBERED.match(piece.chunk.line(at)):
                found.setdefault(number(match[2]), []).append(at)
    return found


def _marks(piece: Piece) -> frozenset[object]:
    found: set[object] = set()
    for reading, shape in piece.distinct():
        if _is_read(reading) and _takes_part(shape, reading):
            found.add(_LINES)
            found |= _said(shape, reading)
    if _VALUES in found:
        for at, _, _ in piece.where(lambda reading, shape: _is_read(reading) and "jump" in shape.facts(reading).kinds):
            found |= _jumps(line_of(piece, at))
    return frozenset(found)


def _said(shape: Shape, reading: Reading) -> frozenset[object]:
    """What lines of a shape say: whether they calculate, and which parameters they read."""
    key = ("z32 parameters said", reading.name)
    found = shape.memo.get(key)
    if found is None:
        found = shape.memo[key] = frozenset(_saying(shape, reading))
    assert isinstance(found, frozenset)
    return found


def _saying(shape: Shape, reading: Reading) -> set[object]:
    kinds = shape.facts(reading).kinds
    found: set[object] = {_VALUES} if not _CALCULATED.isdisjoint(kinds) else set()
    targets = set(_targets(shape, reading))
    for part in walk(shape.tree(reading)):
        if part.kind == "alias_name" and part not in targets:
            found.add(_ALIAS_READ)
        elif part.kind == "axis_alias":
            found |= {f"alias {letter}" for letter in shape.text[part.start : part.end].upper()[-3:]}
        elif (
            part.kind == "NAME" and part not in targets and is_system(name := shape.text[part.start : part.end].upper())
        ):
            found.add(f"reads {name}")
    return found


def _rows(piece: Piece, tracked: frozenset[str]) -> Iterator[int]:
    """The indices of the lines that take part, whatever jumps lead to."""

    def says(reading: Reading, shape: Shape) -> bool:
        return _is_read(reading) and (_takes_part(shape, reading) or not tracked.isdisjoint(_sets(shape, reading)))

    return (at for at, _, _ in piece.where(says))


def _takes_part(shape: Shape, reading: Reading) -> bool:
    facts = shape.facts(reading)
    if facts.problems or not _PARTS.isdisjoint(facts.kinds):
        return True
    return any(not is_system(name) for name in _sets(shape, reading))


def _sets(shape: Shape, reading: Reading) -> frozenset[str]:
    """The names of the parameters that words of a shape set."""
    key = ("z32 names set", reading.name)
    found = shape.memo.get(key)
    if found is None:
        names = (shape.text[part.start : part.end].upper() for part in _targets(shape, reading) if part.kind in _NAMES)
        found = shape.memo[key] = frozenset(names)
    assert isinstance(found, frozenset)
    return found


def _targets(shape: Shape, reading: Reading) -> Iterator[Node | Token]:
    for part in walk(shape.tree(reading)):
        if part.kind in ("word", "assign"):
            assert isinstance(part, Node)
            yield part.children[0]


def _is_read(reading: Reading) -> bool:
    return reading.start is not None
