"""Other names for things, in all programs that name them. Refuses what would change the meaning of a program, by proof: the renamed programs are read again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.refactor import Cannot
from deburr.ide.related import uses, where
from deburr.symbols import Language, Mention, Sort, Symbol, entry_of, language_of
from deburr.symbols.index import Placed, all_symbols, at, mentions_of
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.document import Document

__all__ = ["Cannot", "Change", "prepared", "renamed"]
_NAMED = (Sort.VARIABLE, Sort.SUB, Sort.LABEL, Sort.SECTION)


class Change(NamedTuple):
    """The edits of one file, none of which touches another."""

    file: str
    edits: tuple[Edit, ...]


def prepared(view: View, pos: Pos) -> tuple[Span, str]:
    """What is renamed at a place: its columns, and its name; Cannot if nothing there can be."""
    mention = _renamed(view, pos).mention
    return mention.inner, view.document.line(pos.line)[mention.inner.start : mention.inner.end]


def renamed(view: View, pos: Pos, name: str) -> list[Change]:
    """The edits that give what is named at a place another name; Cannot if they would change what a program means."""
    placed = _renamed(view, pos)
    symbol = placed.mention.symbol
    language = language_of(view.dialect.name)
    assert language is not None
    if wrong := language.valid(symbol, name):
        raise Cannot(wrong)
    changes: dict[str, list[Edit]] = {}
    for each, one in uses(view, symbol, placed.region):
        start, end = one.mention.inner
        changes.setdefault(each.file, []).append(Edit(Pos(one.line, start), Pos(one.line, end), name))
    for each in where(view, symbol):
        _prove(each, placed, changes.get(each.file, []), language)
    return [Change(file, tuple(edits)) for file, edits in changes.items()]


def _renamed(view: View, pos: Pos) -> Placed:
    placed = at(view.document, pos.line, pos.col)
    symbol = placed.mention.symbol if placed is not None else None
    if placed is None or symbol is None or symbol.sort not in _NAMED:
        raise Cannot("nothing here has a name that could be another")
    known = entry_of(symbol, view.dialect.codes)
    language = language_of(view.dialect.name)
    assert language is not None
    if known is not None and not _is_free(symbol, known.more):
        raise Cannot(f"`{language.written(symbol)}` is no name of yours: {known.title}")
    if symbol.name.isdigit() and _computed(view, symbol):
        raise Cannot("a number of this sort is computed somewhere, so what it means cannot be seen")
    return placed


def _is_free(symbol: Symbol, more: object) -> bool:
    """Whether a name of the tables is one that programs use as they like."""
    found = more if isinstance(more, dict) else {}
    return bool(found.get("access") == "read-write" and found.get("known") == "program")


def _computed(view: View, symbol: Symbol) -> bool:
    """Whether some program that can name the symbol names one that only the run knows."""
    unknown = Symbol(symbol.sort, "")
    return any(next(mentions_of(each.document, unknown), None) is not None for each in where(view, symbol))


def _prove(view: View, placed: Placed, edits: Sequence[Edit], language: Language) -> None:
    """The program names the same things at the same places as before, but for the new name."""
    before = view.document
    after = before.edit(*sorted(edits, reverse=True))
    old, region = placed.mention.symbol, placed.region
    changed = {edit.start.line for edit in edits}
    fresh = {one for one in all_symbols(after) if one not in all_symbols(before)}
    name = next((one for one in fresh if one.sort is old.sort), None)
    if edits and name is None:
        raise Cannot("there is something of that name already")
    now = list(mentions_of(after, name, region)) if name is not None else []
    if len(now) != len(edits) or not all(_same(before, after, line, old, name, language) for line in changed):
        raise Cannot("the program would be read in another way")


def _same(before: Document, after: Document, line: int, old: Symbol, new: Symbol | None, language: Language) -> bool:
    """Whether a line still names the same things, one of them by its new name."""
    was = [new if each.symbol == old else each.symbol for each in _mentions(before, line, language)]
    is_now = [each.symbol for each in _mentions(after, line, language)]
    return len(was) == len(is_now) and set(is_now) <= {*was, old}


def _mentions(document: Document, line: int, language: Language) -> list[Mention]:
    return [*language.mentions(document.node(line), language.names(document))]
