"""What is shown above lines: how often a subprogram or section is used."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.related import uses
from deburr.symbols import Act, Sort
from deburr.symbols.index import all_symbols, mentions_of

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.text import Span


class Lens(NamedTuple):
    """A definition, and how many places call it."""

    line: int
    span: Span
    calls: int


def lenses(view: View) -> list[Lens]:
    """The subprograms and sections that a program defines, in order, with their calls from all programs."""
    found = []
    for symbol in all_symbols(view.document):
        if symbol.sort not in (Sort.SUB, Sort.SECTION) or not symbol.name:
            continue
        own = [each for each in mentions_of(view.document, symbol) if each.mention.act is Act.DEFINE]
        calls = sum(each.mention.act is Act.CALL for _, each in uses(view, symbol, None)) if own else 0
        found += [Lens(each.line, each.mention.inner, calls) for each in own]
    return sorted(found)
