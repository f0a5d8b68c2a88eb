"""The lines of a MetaGCODE text that ask for values, its snippets put in where they are named; which they are is kept with each chunk. Judges nothing."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.includes import Folder, leaves
from deburr.values.kept import LINES
from deburr_grammar.dialects.metagcode.forms import condition, is_numeric
from deburr_grammar.dialects.metagcode.limits import DEEPEST, LARGEST
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.document import Piece
    from deburr_grammar.line import Shape

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


class Line:
    """A line that takes part, with what it opens or closes. Where it stands is said beside it, so that equal lines are one object."""

    __slots__ = ("bracket", "compares_texts", "node")

    def __init__(self, node: LineNode, bracket: Bracket | None) -> None:
        self.node = node
        self.bracket = bracket
        self.compares_texts = _compares_texts(node)


class Taken(NamedTuple):
    """The lines that take part, in the order of the gathered text, each with its file and its row."""

    files: list[str]
    rows: list[int]
    lines: list[Line]

    def add(self, file: str, first: int, piece: _Lines, start: int, stop: int) -> None:
        """Take some lines of a piece in, which starts at a row of a file."""
        self.files.extend([file] * (stop - start))
        self.rows.extend([first + row for row in piece.rows[start:stop]])
        self.lines.extend(piece.lines[start:stop])
        if len(self.lines) > _MOST:
            raise Unseen


class _Lines(NamedTuple):
    """The lines of a piece that take part, with their rows in it; which of them name snippets."""

    rows: list[int]
    lines: list[Line]
    snippets: list[int]


def concerns(document: Document) -> Generator[None, None, bool]:
    """Whether there is a condition or a loop."""
    yield from document.gathering(_KEY, _marks)
    return _ASKS in document.gathered(_KEY, _marks)


def taken(analysis: Analysis) -> Generator[None, None, Taken]:
    """The lines that take part, found in steps."""
    folder = Folder(analysis.host, analysis.file, str(analysis.settings["snippets-dir"]))
    found = Taken([], [], [])
    yield from _gather(analysis.document, analysis.file, folder, {}, 0, found)
    return found


def _gather(
    document: Document, file: str, folder: Folder, read: dict[str, Document], depth: int, found: Taken
) -> Iterator[None]:
    for piece in document.holding(_KEY, _marks, _LINES):
        here, start = _of_piece(document, piece), 0
        for at in here.snippets:
            # The line itself stands before what it puts in.
            found.add(file, piece.line, here, start, at + 1)
            start = at + 1
            bracket = here.lines[at].bracket
            name = bracket.label if bracket is not None else None
            snippet = folder.find(name) if name and not leaves(name) and "|" not in name else None
            if snippet is None or depth == DEEPEST or snippet.larger(LARGEST):
                raise Unseen
            inner = read.setdefault(snippet.path, Document.parse(snippet.text, document.dialect))
            yield from _gather(inner, snippet.path, folder, read, depth + 1, found)
        found.add(file, piece.line, here, start, len(here.lines))
        yield


def _of_piece(document: Document, piece: Piece) -> _Lines:
    key = ("metagcode lines that take part", document.key(piece))
    found: _Lines | None = piece.chunk.memo.get(key)
    if found is None:
        brackets, reading = dict(piece.outlined.brackets), piece.outlined.reading
        text, shapes, rows = piece.chunk.line, piece.chunk.shapes, list(_wanted(piece))
        lines = [_line(text(at), reading(at), shapes[at], brackets.get(at)) for at in rows]
        snippets = [at for at, line in enumerate(lines) if line.bracket is not None and line.bracket.kind == SNIPPET]
        found = piece.chunk.memo[key] = _Lines(rows, lines, snippets)
    return found


@lru_cache(maxsize=LINES)
def _line(text: str, reading: Reading, shape: Shape, bracket: Bracket | None) -> Line:
    """A line: one that says the same as before is the same, so that what hangs on it need not be found again."""
    return Line(LineNode(text, reading, shape), bracket)


def _compares_texts(node: LineNode) -> bool:
    """Whether a line has a condition that is not on numbers; its shape says so, whose tree is there, while that of each line would have to be made."""
    reading, shape = node.reading, node.shape
    key = ("metagcode compares texts", reading.name)
    found = shape.memo.get(key)
    if found is None:
        sample = LineNode(shape.text, reading, shape)
        types = [condition(part).type for part in sample.find("condition")] if not sample.problems else []
        found = shape.memo[key] = any(not is_numeric(shape.text[each.start : each.end]) for each in types)
    return bool(found)


def _marks(piece: Piece) -> frozenset[str]:
    found = set()
    for reading, shape in piece.distinct():
        if not shape.facts(reading).kinds.isdisjoint(_ASKING):
            found.add(_ASKS)
        if _LINES not in found and _takes_part(reading, shape):
            found.add(_LINES)
    return frozenset(found)


def _wanted(piece: Piece) -> Iterator[int]:
    return (at for at, _, _ in piece.where(_takes_part))


def _takes_part(reading: Reading, shape: Shape) -> bool:
    return not shape.facts(reading).kinds.isdisjoint(_KINDS) or SIGNED.search(shape.text) is not None
