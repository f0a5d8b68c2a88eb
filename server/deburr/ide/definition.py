"""Where a name leads: to the place that defines it, to its file, or to where it is given a value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.ide.related import uses
from deburr.ide.view import Spot
from deburr.symbols import Act, Sort, Symbol, language_of
from deburr.symbols.index import Placed, at
from deburr_grammar.text import Pos, Span

if TYPE_CHECKING:
    from deburr.ide.view import View


def definition(view: View, pos: Pos) -> list[Spot]:
    """The places that a name at a place leads to."""
    placed = at(view.document, pos.line, pos.col)
    return [] if placed is None else definitions(view, placed)


def definitions(view: View, placed: Placed) -> list[Spot]:
    """The places that define what is named; without any, its file, or where it is set."""
    symbol, act = placed.mention.symbol, placed.mention.act
    if symbol.sort is Sort.SECTION and act is Act.CALL and (file := file_of(view, symbol)):
        # Where programs have files of their own, a call leads to no section of this one.
        return [Spot(file, 0, Span(0, 0))]
    defining = _spots(view, placed, Act.DEFINE)
    if defining:
        return [spot for spot in defining if spot.file == view.file] or defining
    if file := file_of(view, symbol):
        return [Spot(file, 0, Span(0, 0))]
    return _spots(view, placed, Act.SET)


def _spots(view: View, placed: Placed, act: Act) -> list[Spot]:
    found = uses(view, placed.mention.symbol, placed.region, act)
    return [Spot(each.file, one.line, one.mention.inner) for each, one in found]


def file_of(view: View, symbol: Symbol) -> str | None:
    """The file that a symbol stands for."""
    language = language_of(view.dialect.name)
    return None if language is None else language.file(symbol, view.file, view.ruleset, view.host)
