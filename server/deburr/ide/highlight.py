"""What belongs together in one program: the uses of a name, and the words of a block."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.symbols import Act
from deburr.symbols.index import at, mentions_of
from deburr_grammar.dialect import Bracket, Role

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.document import Document
    from deburr_grammar.text import Pos, Span

_MOST = 2_000


class Highlight(NamedTuple):
    """A place, and whether something is written there; None: it is just named."""

    line: int
    span: Span
    writes: bool | None


def highlights(view: View, pos: Pos) -> list[Highlight]:
    """The places that belong to the one at the cursor."""
    blocks = list(pair(view.document, pos))
    if blocks:
        return blocks
    placed = at(view.document, pos.line, pos.col)
    if placed is None:
        return []
    found = []
    for each in mentions_of(view.document, placed.mention.symbol, placed.region):
        acts = {Act.SET: True, Act.DEFINE: True, Act.READ: False}
        found.append(Highlight(each.line, each.mention.inner, acts.get(each.mention.act)))
        if len(found) >= _MOST:
            break
    return found


def pair(document: Document, pos: Pos) -> Iterator[Highlight]:
    """The opener and closer of the block on whose word the cursor stands."""
    bracket = bracket_at(document, pos)
    if bracket is None or bracket.role not in (Role.OPEN, Role.CLOSE):
        return
    other = document.partner(pos.line, bracket)
    ends = [(pos.line, bracket), *([other] if other is not None else [])]
    yield from (Highlight(line, each.span, None) for line, each in sorted(ends, key=lambda end: (end[0], end[1].span)))


def bracket_at(document: Document, pos: Pos) -> Bracket | None:
    """The bracket at a place."""
    piece = document.piece(pos.line)
    found = (bracket for index, bracket in piece.outlined.brackets if piece.line + index == pos.line)
    return next((bracket for bracket in found if bracket.span.start <= pos.col <= bracket.span.end), None)
