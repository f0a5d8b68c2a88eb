"""The lines of a template that take part, by sections: which they are is kept with each chunk. Never looks at what a word means."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from functools import lru_cache, reduce
from typing import TYPE_CHECKING, NamedTuple

from deburr.templates.items import declarations_of
from deburr.values.kept import LINES
from deburr_grammar.dialects.cgt.outline import section_name
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import Shape

_ASKING = frozenset(("WORD", "lookup", "repeat"))
_KEY = "cgt values"
_LINES, _VALUES = "lines that take part", "words"
_NAMING = frozenset(("DECLARE", "eval", "call"))
_SIGNS = frozenset("#<>")
_MOST = 20_000
"""Lines that take part; of a template with more nothing is said."""


class Unread(Exception):
    """Inside this package: the template cannot be read, so that nobody knows what it does."""


class Names(NamedTuple):
    """What lines name: words that they declare, each with the command that does so, words that `#EVAL` sets, sections that they call."""

    declares: tuple[tuple[str, str], ...] = ()
    sets: tuple[str, ...] = ()
    calls: tuple[str, ...] = ()

    def and_of(self, other: Names) -> Names:
        """What both name."""
        return Names(self.declares + other.declares, self.sets + other.sets, self.calls + other.calls)


class Part(NamedTuple):
    """A section's lines that take part. ``row``: its header's in the template; ``reading``: how they are read.

    ``lines`` are the rows, counted from the header, each with what it says; ``nodes`` what they were read as; ``names`` what they name, whatever that means.
    """

    name: str
    row: int
    reading: str = "template"
    lines: tuple[tuple[int, str], ...] = ()
    nodes: tuple[LineNode, ...] = ()
    names: Names = Names()

    def behind(self, other: Part) -> Part:
        """With the lines that stand before it, from the header on, where that stands in an earlier piece."""
        lines = tuple((self.row - other.row + row, text) for row, text in self.lines)
        reading, names = other.reading if other.lines else self.reading, other.names.and_of(self.names)
        return other._replace(reading=reading, lines=other.lines + lines, nodes=other.nodes + self.nodes, names=names)


class _Piece(NamedTuple):
    """The parts of sections in one piece, with rows that count from its first line. What stands before its first header is a part without a name."""

    parts: tuple[Part, ...]
    taken: int
    """How many lines take part, with the headers."""
    unread: bool
    """Whether one of them cannot be read."""


_NONE = Names()


def concerns(document: Document) -> Generator[None, None, bool]:
    """Whether any line has something that has a value."""
    yield from document.gathering(_KEY, _marks)
    return _VALUES in document.gathered(_KEY, _marks)


def sections(document: Document) -> Generator[None, None, list[Part]]:
    """The sections in order, found in steps. It raises `Unread` where a line that takes part cannot be read."""
    found: list[Part] = []
    count = 0
    for piece in document.holding(_KEY, _marks, _LINES):
        known = _of_piece(document, piece)
        count += known.taken
        if count > _MOST or known.unread:
            raise Unread
        for part in known.parts:
            here = part._replace(row=piece.line + part.row)
            if part.name:
                found.append(here)
            elif found:
                found[-1] = here.behind(found[-1])
        yield
    return found


def _of_piece(document: Document, piece: Piece) -> _Piece:
    key = ("cgt lines that take part", document.key(piece))
    found: _Piece | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = _read(piece)
    return found


def _read(piece: Piece) -> _Piece:
    name, row, count, unread = "", 0, 0, False
    lines: list[tuple[int, _Line]] = []
    parts: list[Part] = []
    said = piece.chunk.lines
    for at, reading, shape in _wanted(piece):
        line = _line(said[at], reading, shape)
        count += 1
        unread = unread or line.unread
        if not line.header:
            lines.append((at, line))
        if line.section:
            parts += _part(name, row, lines)
            name, row, lines = line.section, at, []
    parts += _part(name, row, lines)
    return _Piece(tuple(parts), count, unread)


def _part(name: str, row: int, lines: list[tuple[int, _Line]]) -> Iterator[Part]:
    """A section's lines in a piece, if there are any."""
    if lines:
        named = dict.fromkeys(line.names for _, line in lines)
        names = reduce(Names.and_of, named)
        nodes = tuple(line.node for _, line in lines)
        said = tuple((at - row, line.node.text) for at, line in lines)
        yield Part(name, row, nodes[0].reading.name, said, nodes, names)
    elif name:
        yield Part(name, row)


class _Line(NamedTuple):
    """A line that takes part: what it was read as, and what it names; of a header the section that it begins, if any."""

    node: LineNode
    names: Names
    header: bool
    section: str
    unread: bool


@lru_cache(maxsize=LINES)
def _line(text: str, reading: Reading, shape: Shape) -> _Line:
    """A line by what it says: one that says the same as before is the same, so that what hangs on it need not be found again."""
    node = LineNode(text, reading, shape)
    header = reading.name == "header"
    return _Line(node, _names(node), header, section_name(node)[0] if header else "", bool(node.problems))


def _names(node: LineNode) -> Names:
    if node.kinds.isdisjoint(_NAMING):
        return _NONE
    declared = tuple((each.name, each.command) for each in declarations_of(0, node))
    return Names(declared, tuple(_named(node, "eval", "WORD")), tuple(_named(node, "call", "SECTION")))


def _named(node: LineNode, command: str, kind: str) -> Iterator[str]:
    """The first of the parts of a kind in each command of a sort."""
    for part in node.find(command) if command in node.kinds else ():
        token = next((each for each in part.children if each.kind == kind), None)
        if token is not None:
            yield node.text[token.start : token.end]


def _marks(piece: Piece) -> frozenset[str]:
    found: set[str] = set()
    for reading, _, shapes in piece.read():
        for shape in set(shapes):
            if _takes_part(shape, reading):
                found.add(_LINES)
            if reading.start is not None and not _ASKING.isdisjoint(shape.facts(reading).kinds):
                found.add(_VALUES)
    return frozenset(found)


def _wanted(piece: Piece) -> Iterator[tuple[int, Reading, Shape]]:
    for reading, first, shapes in piece.read():
        wanted = {shape for shape in set(shapes) if _takes_part(shape, reading)}
        yield from ((at, reading, shape) for at, shape in enumerate(shapes, first) if shape in wanted)


def _takes_part(shape: Shape, reading: Reading) -> bool:
    if reading.start is None:
        return False
    return (
        reading.name in ("header", "table") or not _SIGNS.isdisjoint(shape.text) or bool(shape.facts(reading).problems)
    )
