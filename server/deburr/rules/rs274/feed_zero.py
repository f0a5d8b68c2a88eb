"""Move at a feed rate of zero.

`F0` is accepted, but the next move that needs a feed rate is refused: the control stops there, as
with "Cannot do g1 with zero feed rate".

Source: spec/rs274.md §5

Bad:

    G1 X1 F0
    ^^

Bad:

    F0.0
    G0 X1
    G1 X2
    ^^
    X3

Good:

    F0
    G0 X1
    G1 X2 F100
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.modal import modal_of
from deburr.rule import Line, Note, Report, Severity, Whole, rule
from deburr.rules.rs274._words import UNKNOWN, Words, governs, motion, node, said, values, words
from deburr.ruleset import Searched
from deburr_grammar.dialects.rs274.modality import AXES, FEEDS
from deburr_grammar.document import Piece
from deburr_grammar.text import Span, with_newlines

_ZERO = Searched(r"[Ff][ \t]*[+-]?[ \t]*[0.][0. \t]*(?![0-9.])", "Ff")
_FARTHEST = 1_000
"""Lines within which the move is looked for."""


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first move behind each feed rate of zero."""
    for zero in _zeroes(analysis):
        if (moved := _move(analysis, zero)) is not None:
            at, line, number = moved
            word = node(line, number)
            notes = () if at == zero else (Note(zero, _feed(analysis, zero), "the feed rate is set to zero here"),)
            message = f"`{said(line, number)}` moves at a feed rate of zero; write another F word before it"
            yield Report(Span(word.start, word.end), message, at, notes)


def _zeroes(analysis: Analysis) -> Iterator[int]:
    for piece in analysis.document.pieces():
        key = ("rs274 F0", analysis.document.key(piece))
        if key not in piece.chunk.memo:
            piece.chunk.memo[key] = tuple(_of_piece(analysis, piece))
        yield from (piece.line + index for index in piece.chunk.memo[key])


def _of_piece(analysis: Analysis, piece: Piece) -> Iterator[int]:
    for index in _ZERO.lines(with_newlines(piece.chunk.text)):
        if values(Line(piece.node(index), analysis.settings)).get("F") == 0:
            yield index


def _move(analysis: Analysis, zero: int) -> tuple[int, Line, int] | None:
    """The first move that is certain to be made at the feed rate of a line: its line, and the number of its word there."""
    fold = modal_of(analysis.dialect)
    assert fold is not None
    for at in range(zero, min(zero + _FARTHEST, analysis.document.line_count)):
        line = Line(analysis.document.node(at), analysis.settings)
        found = words(line)
        if _ends(line, found) or (at > zero and not found.has.isdisjoint(("F", "G93", "G94", "G95"))):
            return None
        state = analysis.document.state(fold, at)
        made = motion(found, state)
        if made == UNKNOWN or governs(found, state, "feed-mode") not in ("G94", "G95"):
            return None
        if made in FEEDS:
            return at, line, found.first(made) if made in found.has else found.first(*AXES, "I", "J", "K")
    return None


def _ends(line: Line, found: Words) -> bool:
    """Whether what runs next is not the next line, or not certain."""
    read = line.node
    if read.reading.start is None or read.problems or not read.kinds.isdisjoint(("o_line", "DELETE")):
        return True
    return not found.clear or not found.has.isdisjoint(("M70", "M72", "M73", "M98", "M99", "M2", "M30"))


def _feed(analysis: Analysis, at: int) -> Span:
    line = Line(analysis.document.node(at), analysis.settings)
    word = node(line, words(line).first("F"))
    return Span(word.start, word.end)
