"""Labels that must stay alike: those of the words of one block."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.ide.highlight import bracket_at, pair
from deburr.ide.view import Spot
from deburr.symbols import Sort
from deburr.symbols.index import at, mentions_of
from deburr_grammar.text import Pos, Span

if TYPE_CHECKING:
    from deburr.ide.view import View


def linked(view: View, pos: Pos) -> list[Spot]:
    """The labels that change together with the one at a place; none where there is no such, or only one."""
    placed = at(view.document, pos.line, pos.col)
    if placed is not None and placed.mention.symbol.sort is Sort.LABEL:
        if not placed.mention.symbol.local:
            return []
        found = mentions_of(view.document, placed.mention.symbol, placed.region)
        spots = [Spot(view.file, each.line, each.mention.inner) for each in found]
    else:
        spots = _of_block(view, pos)
    touched = any(spot.line == pos.line and spot.span.start <= pos.col <= spot.span.end for spot in spots)
    return spots if len(spots) > 1 and touched else []


def _of_block(view: View, pos: Pos) -> list[Spot]:
    """The labels of an opener and its closer, if both have the same."""
    bracket = bracket_at(view.document, pos)
    label = bracket.label if bracket is not None else None
    spots = []
    for each in pair(view.document, pos) if label else ():
        said = view.document.line(each.line)[each.span.start : each.span.end]
        if label and said.endswith(label):
            spots.append(Spot(view.file, each.line, Span(each.span.end - len(label), each.span.end)))
    return spots
