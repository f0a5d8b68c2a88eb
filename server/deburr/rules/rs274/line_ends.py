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
from itertools import pairwise
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr_grammar.document import Piece
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis

_JOINED = r"\S[^\S\r\n]*\r[^\S\n]*\S"


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report the first line that runs into the next: where there is one, there are mostly many."""
    for piece, following in pairwise((*analysis.document.pieces(), None)):
        assert piece is not None
        if (at := _joined(piece, following)) is not None:
            index = bisect_right(piece.chunk.starts, at) - 1
            text = piece.chunk.line(index)
            span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
            message = "a carriage return alone ends no line: the control reads this line and the next as one; save the file with line feeds"
            yield Report(span, message, piece.line + index)
            return


def _joined(piece: Piece, following: Piece | None) -> int | None:
    """Where in a chunk something stands before a carriage return that something follows."""
    chunk = piece.chunk
    if "joined lines" not in chunk.memo:
        match = re.search(_JOINED, chunk.text) if "\r" in chunk.text else None
        chunk.memo["joined lines"] = match.start() if match else None
    found: int | None = chunk.memo["joined lines"]
    if found is not None or following is None or not chunk.text.endswith("\r"):
        return found
    last = chunk.starts[-2]
    match = re.search(_JOINED, chunk.text[last:] + following.chunk.text)
    return last + match.start() if match and match.start() < len(chunk.text) - last else None


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
