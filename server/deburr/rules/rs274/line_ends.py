"""Line that ends with a carriage return alone.

The interpreter ends a line at a line feed. A carriage return without one is a blank to it, so that
it reads this line and the next as one: words repeat, or run in another order than they stand.
Editors show two lines. In the example `␍` is a carriage return.

Source: spec/oracle.md §4

Bad (whole):

    G0 X1␍G1 X2 F100␍M2
    ^^^^^

Bad (whole):

    G21 (mm)␍
    G0 X1 (park)  ␍G0 X2
    ^^^^^^^^^^^^
    M2

Good (whole):

    G0 X1␍
    ␍
    M2␍
"""

import re
from bisect import bisect_right
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr_grammar.chunk import Chunk
from deburr_grammar.document import Piece
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis

_ENDED = r"\S[^\S\r\n]*\r[^\S\n]*"
"""Something before a carriage return, and the blank lines behind it that no line feed ends."""
_BLANK = re.compile(r"[^\S\n]*")


class _Ends(NamedTuple):
    """Where in a chunk something stands before a carriage return: one that something follows there, and one that nothing follows in the chunk."""

    joined: int | None
    last: int | None


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report the first line that runs into the next: where there is one, there are mostly many."""
    before: tuple[Piece, int] | None = None
    for piece in analysis.document.pieces():
        chunk = piece.chunk
        if before is not None and (first := chunk.text[_BLANK.match(chunk.text).end() :][:1]):  # type: ignore[union-attr]  # it matches nothing, too
            if first != "\n":
                yield _report(*before)
                return
            before = None
        ends = _ends(chunk)
        if ends.joined is not None:
            yield _report(piece, ends.joined)
            return
        if ends.last is not None:
            before = piece, ends.last


def _ends(chunk: Chunk) -> _Ends:
    if "joined lines" not in chunk.memo:
        found = list(re.finditer(rf"{_ENDED}(?=\S|\Z)", chunk.text)) if "\r" in chunk.text else []
        inside = next((match.start() for match in found if match.end() < len(chunk.text)), None)
        last = next((match.start() for match in found if match.end() == len(chunk.text)), None)
        chunk.memo["joined lines"] = _Ends(inside, last)
    ends: _Ends = chunk.memo["joined lines"]
    return ends


def _report(piece: Piece, at: int) -> Report:
    index = bisect_right(piece.chunk.starts, at) - 1
    text = piece.chunk.line(index)
    span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
    message = "a carriage return alone ends no line: the control reads this line and the next as one; save the file with line feeds"
    return Report(span, message, piece.line + index)


def fix(broken: Broken) -> Iterator[Fix]:
    """End all lines with line feeds."""
    document = broken.document
    ends: list[Edit] = []
    for piece in document.pieces():
        for index in range(piece.chunk.eols):
            if piece.chunk.ending(index) == "\r":
                line = piece.line + index
                ends.append(Edit(Pos(line, len(document.line(line))), Pos(line + 1, 0), "\n"))
    yield Fix("End all lines with line feeds", tuple(ends))
