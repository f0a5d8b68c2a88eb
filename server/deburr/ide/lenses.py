"""What is shown above lines: how often a subprogram or section is called, how often a loop goes round. Counts nothing before it is asked to."""

from __future__ import annotations

from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.known import held, loops
from deburr.ide.related import uses
from deburr.ide.view import Spot
from deburr.symbols import Act, Sort, Symbol
from deburr.symbols.constants import constants_of
from deburr.symbols.index import all_symbols, at, mentions_of
from deburr_grammar.dialect import Role

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.text import Pos, Span

_MOST = 1_000
"""So many lenses of a program at the most."""


class Lens(NamedTuple):
    """A place, and the kind of lens that stands above it; ``text``: what it says, if that is known without counting."""

    line: int
    span: Span
    kind: str
    text: str = ""


def lenses(view: View) -> list[Lens]:
    """The lenses of a program, in order: of what it defines and others call, and of its loops."""
    return sorted([*_definitions(view), *_loops(view)])[:_MOST]


def callers(view: View, pos: Pos) -> list[Spot]:
    """The places in all programs that call or read what is defined at a place."""
    placed = at(view.document, pos.line, pos.col)
    if placed is None:
        return []
    found = uses(view, placed.mention.symbol, None)
    return [
        Spot(each.file, one.line, one.mention.inner) for each, one in found if one.mention.act in (Act.CALL, Act.READ)
    ]


def _definitions(view: View) -> list[Lens]:
    found: list[Lens] = []
    for symbol in all_symbols(view.document, Sort.SUB, Sort.SECTION):
        if symbol.name and not _is_systems(view, symbol):
            own = mentions_of(view.document, symbol)
            found += [Lens(one.line, one.mention.inner, "references") for one in own if one.mention.act is Act.DEFINE]
    return found


def _is_systems(view: View, symbol: Symbol) -> bool:
    """Whether a section is one that the control runs by itself."""
    return symbol.sort is Sort.SECTION and view.dialect.codes.entry("section", symbol.name) is not None


def _loops(view: View) -> list[Lens]:
    constants = constants_of(view.dialect.name)
    if constants is None:
        return []
    found = {line: Lens(line, span, "passes", text) for line, span, text in islice(loops(view), _MOST)}
    for line, bracket in view.document.brackets():
        for head in _heads(view, line, bracket) if len(found) < _MOST else ():
            lengths = list(constants.lengths(view.document, head, partial(held, view), view.ruleset.settings))
            text = " · ".join(each.text for each in lengths)
            if text and head not in found:
                found[head] = Lens(head, bracket.span if bracket.kind in _LOOPS else lengths[0].span, "passes", text)
    return list(found.values())


def _heads(view: View, line: int, bracket: Bracket) -> list[int]:
    """The line that says how often a block goes round that opens on a line: this one, or the one above where the sign that opens it may stand below."""
    if bracket.role is not Role.OPEN:
        return []
    if bracket.kind in _LOOPS:
        return [line]
    near = range(max(0, line - 1), line + 1)
    return [each for each in near if "repeat" in view.document.node(each).kinds]


_LOOPS = frozenset(("loop", "repeat", "while"))
