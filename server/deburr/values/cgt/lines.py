"""The lines of a template that take part, by sections: which they are is kept with each chunk. Never looks at what a word means."""

from __future__ import annotations

from collections.abc import Generator, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.templates.items import declarations_of
from deburr.values.kept import LINES, line_of
from deburr_grammar.dialects.cgt.outline import section_name

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.line import LineNode, Shape

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
    """What a line names: words that it declares, each with the command that does so, words that `#EVAL` sets, sections that it calls."""

    declares: tuple[tuple[str, str], ...] = ()
    sets: tuple[str, ...] = ()
    calls: tuple[str, ...] = ()


class Taken(NamedTuple):
    """A line that takes part. ``row``: its place in the template; ``names``: what it names, whatever that means."""

    row: int
    node: LineNode
    names: Names


class Part(NamedTuple):
    """A section's lines that take part; ``row`` is its header's, ``reading`` is how they are read."""

    name: str
    row: int
    reading: str
    lines: list[Taken]


_NONE = Names()


def concerns(document: Document) -> bool:
    """Whether any line has something that has a value."""
    return _VALUES in document.gathered(_KEY, _marks)


def sections(document: Document) -> Generator[None, None, list[Part]]:
    """The sections in order, found in steps. It raises `Unread` where a line that takes part cannot be read."""
    found: list[Part] = []
    count = 0
    for piece in document.holding(_KEY, _marks, _LINES):
        lines = _of_piece(document, piece)
        count += len(lines)
        if count > _MOST:
            raise Unread
        for index, node, names in lines:
            if node.problems:
                raise Unread
            if node.reading.name == "header":
                name, _ = section_name(node)
                if name:
                    found.append(Part(name, piece.line + index, "template", []))
            elif found:
                if not found[-1].lines:
                    found[-1] = found[-1]._replace(reading=node.reading.name)
                found[-1].lines.append(Taken(piece.line + index, node, names))
        yield
    return found


def _of_piece(document: Document, piece: Piece) -> list[tuple[int, LineNode, Names]]:
    key = ("cgt lines that take part", document.key(piece))
    found: list[tuple[int, LineNode, Names]] | None = piece.chunk.memo.get(key)
    if found is None:
        nodes = ((at, line_of(piece, at)) for at in _wanted(piece))
        found = piece.chunk.memo[key] = [(at, node, _names(node)) for at, node in nodes]
    return found


@lru_cache(maxsize=LINES)
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


def _wanted(piece: Piece) -> Iterator[int]:
    for reading, first, shapes in piece.read():
        wanted = {shape for shape in set(shapes) if _takes_part(shape, reading)}
        yield from (at for at, shape in enumerate(shapes, first) if shape in wanted) if wanted else ()


def _takes_part(shape: Shape, reading: Reading) -> bool:
    if reading.start is None:
        return False
    return (
        reading.name in ("header", "table") or not _SIGNS.isdisjoint(shape.text) or bool(shape.facts(reading).problems)
    )
