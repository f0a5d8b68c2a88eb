"""Where a name is used: in the program, and in those that it calls or that call it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.ide.related import uses
from deburr.ide.view import Spot
from deburr.symbols import Act
from deburr.symbols.index import at

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.text import Pos


def references(view: View, pos: Pos, *, definitions: bool = True) -> list[Spot]:
    """All places that name what is named at a place; with those that define it, if they are wanted."""
    placed = at(view.document, pos.line, pos.col)
    if placed is None:
        return []
    found = uses(view, placed.mention.symbol, placed.region)
    wanted = (each for each in found if definitions or each[1].mention.act is not Act.DEFINE)
    return [Spot(each.file, one.line, one.mention.inner) for each, one in wanted]
