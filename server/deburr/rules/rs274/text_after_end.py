"""Text behind the end of the program.

The control reads nothing behind M2, M30 or the closing `%`: what stands there is neither run nor
checked. Comments, and subprograms behind M2 that are found by their calls, are not meant.

Source: spec/rs274.md §1.1

Bad:

    M30
    G0 X1
    ^^^^^
    X2

Bad (whole):

    %
    G0 X1
    %
    (next part)
    G0 X2
    ^^^^^
    M2

Good (whole):

    o1 sub
      G0 X1
    o1 endsub
    o1 call
    o2 call
    M2
    (drills a hole)
    o2 sub
      G0 X2
    o2 endsub
    %

Good (whole):

    M98 P100
    M30
    o100
    G0 X1
    M99
"""

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._frame import percents, starts_with_percent
from deburr_grammar.document import Piece
from deburr_grammar.line import Shape
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis

_NOTHING = r"\s*(?:\([^()]*\)\s*)*(?:;.*|%.*)?"


@rule(Severity.INFO, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report the first line of each stretch that is never read. A percent sign that is an error ends nothing."""
    late = told = bool(percents(analysis)) and not starts_with_percent(analysis)
    for piece in analysis.document.pieces():
        for read, index in _stretches(analysis, piece):
            told = late or told and not read
            if index is not None and not told:
                text = piece.chunk.line(index)
                span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
                yield Report(span, "this is never read: the program has ended before it", piece.line + index)
                told = True


def _stretches(analysis: "Analysis", piece: Piece) -> tuple[tuple[bool, int | None], ...]:
    """The stretches of a chunk: whether each is read, and the first line with text of one that is not."""
    key = ("text after end", analysis.document.key(piece))
    if key not in piece.chunk.memo:
        piece.chunk.memo[key] = tuple(
            (reading.start is not None, None if reading.start is not None else _first(first, shapes))
            for reading, first, shapes in piece.read()
        )
    found: tuple[tuple[bool, int | None], ...] = piece.chunk.memo[key]
    return found


def _first(first: int, shapes: list[Shape]) -> int | None:
    return next((at for at, shape in enumerate(shapes, first) if not re.fullmatch(_NOTHING, shape.text)), None)


def fix(broken: Broken) -> Iterator[Fix]:
    """Delete all that follows; calls look for subprograms behind the end, so where there are O-words it stays."""
    count = broken.document.line_count
    rest = [broken.document.line(at).strip() for at in range(broken.line, count)]
    last = rest.index("%") if "%" in rest else len(rest)
    if not any(re.search(r"\bO\s*[0-9<\[#]", text, re.I) for text in rest):
        end = Pos(broken.line + last, 0) if last < len(rest) else Pos(count, 0)
        yield Fix("Delete what is never read", (Edit(Pos(broken.line, 0), end, ""),))
