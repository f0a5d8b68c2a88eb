"""The lines of a MetaGCODE text that ask for values, its snippets put in where they are named; which they are is kept with each chunk. Judges nothing."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.includes import Folder, leaves
from deburr.steps import paced
from deburr.values.kept import line_of
from deburr_grammar.dialects.metagcode.limits import DEEPEST, LARGEST
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Piece
    from deburr_grammar.line import LineNode

SIGNED = re.compile(r"(?<=[A-Za-z])[ \t]*[+-][ \t]*(\|([^|\r\n]*)\|)")
"""A word whose sign stands before its value."""
_KINDS = frozenset(("if", "loop", "endif", "endloop", "file", "unknown"))
_ASKING = frozenset(("condition", "header"))
_KEY = "metagcode values"
_LINES, _ASKS = "lines that take part", "conditions and loops"
_MOST = 20_000
"""Lines that take part, snippets included; a text with more is not looked at."""


class Unseen(Exception):
    """Inside this package: what a line puts in cannot be seen."""


class Taken(NamedTuple):
    """A line that takes part: its file, its row, what it opens or closes."""

    file: str
    row: int
    node: LineNode
    bracket: Bracket | None


def concerns(document: Document) -> bool:
    """Whether there is a condition or a loop."""
    return _ASKS in document.gathered(_KEY, _marks)


def taken(analysis: Analysis) -> Generator[None, None, list[Taken]]:
    """The lines that take part, in the order of the gathered text, found in steps."""
    folder = Folder(analysis.host, analysis.file, str(analysis.settings["snippets-dir"]))
    found: list[Taken] = []
    yield from _gather(analysis.document, analysis.file, folder, {}, 0, found)
    return found


def _gather(
    document: Document, file: str, folder: Folder, read: dict[str, Document], depth: int, found: list[Taken]
) -> Iterator[None]:
    for line in paced(_of_document(document, file)):
        if line is None:
            yield
            continue
        if line.bracket is None or line.bracket.kind != SNIPPET:
            found.append(line)
            if len(found) > _MOST:
                raise Unseen
            continue
        name = line.bracket.label
        snippet = folder.find(name) if name and not leaves(name) and "|" not in name else None
        if snippet is None or depth == DEEPEST or snippet.larger(LARGEST):
            raise Unseen
        inner = read.setdefault(snippet.path, Document.parse(snippet.text, document.dialect))
        yield from _gather(inner, snippet.path, folder, read, depth + 1, found)


def _of_document(document: Document, file: str) -> Iterator[Taken]:
    for piece in document.holding(_KEY, _marks, _LINES):
        for index, node, bracket in _of_piece(document, piece):
            yield Taken(file, piece.line + index, node, bracket)


def _of_piece(document: Document, piece: Piece) -> list[tuple[int, LineNode, Bracket | None]]:
    key = ("metagcode lines that take part", document.key(piece))
    found: list[tuple[int, LineNode, Bracket | None]] | None = piece.chunk.memo.get(key)
    if found is None:
        brackets = dict(piece.outlined.brackets)
        found = piece.chunk.memo[key] = [(at, line_of(piece, at), brackets.get(at)) for at in _wanted(piece)]
    return found


def _marks(piece: Piece) -> frozenset[str]:
    found = {_LINES for _ in _wanted(piece)}
    for reading, _, shapes in piece.read():
        if any(not shape.facts(reading).kinds.isdisjoint(_ASKING) for shape in set(shapes)):
            found.add(_ASKS)
    return frozenset(found)


def _wanted(piece: Piece) -> Iterator[int]:
    for reading, first, shapes in piece.read():
        wanted = {
            shape
            for shape in set(shapes)
            if not shape.facts(reading).kinds.isdisjoint(_KINDS) or SIGNED.search(shape.text) is not None
        }
        yield from (at for at, shape in enumerate(shapes, first) if shape in wanted) if wanted else ()
