"""What can stand at a place: what the grammar expects there, filled with the names that there are. Offers nothing that the line could not take."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.hover import described, rows
from deburr.ide.related import related
from deburr.symbols import Act, Language, Offer, Sort, Symbol, entry_of, language_of
from deburr.symbols.constants import constants_of
from deburr.symbols.index import all_symbols, at, first_symbols, locals_of, mentions_of, on_line, region
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.codes import Entry
    from deburr_grammar.dialect import Dialect
    from deburr_grammar.text import Pos

_SORTS = {
    Offer.VARIABLES: Sort.VARIABLE,
    Offer.SUBS: Sort.SUB,
    Offer.LABELS: Sort.LABEL,
    Offer.SECTIONS: Sort.SECTION,
}
_BARE = (Sort.SECTION, Sort.LABEL)
"""Where these are named, their sign is not written again."""


MOST = 250
"""So many names of a program are offered at a place; a program may have a label on every line."""


class Item(NamedTuple):
    """Something that can be written: in full, what it is, in short what it means, and the columns that it replaces."""

    text: str
    sort: str
    detail: str
    span: Span
    table: str = ""
    """The table and the name under which `resolved` finds more."""
    name: str = ""


def completions(view: View, pos: Pos) -> list[Item]:
    """All that can be written at a place, in the order in which it is offered."""
    language = language_of(view.dialect.name)
    if language is None:
        return []
    before = view.document.line(pos.line)[: pos.col]
    start = language.partial(before)
    span = Span(start, pos.col)
    known = expected(view, pos.line, language.resumed(before[:start]))
    offers = list(language.offers(known, before[:start], before[start:]))
    found: dict[str, Item] = {}
    for item in _items(view, pos, language, offers, span):
        found.setdefault(item.text, item)
    wanted = before[start:].lower()
    return [item for item in found.values() if item.text.lower().startswith(wanted[:1]) or not wanted]


def expected(view: View, line: int, before: str) -> frozenset[str]:
    """The terminals that the grammar takes behind the start of a line."""
    reading = view.document.node(line).reading
    if reading.start is None:
        return frozenset()
    return view.dialect.grammar.following(reading.start, before)


def resolved(dialect: Dialect, table: str, name: str) -> str:
    """All that a table says of an item, in Markdown."""
    entry = dialect.codes.entry(table, name)
    return "" if entry is None else "\n\n".join(part for part in (*described(entry), rows(entry)) if part)


def _items(view: View, pos: Pos, language: Language, offers: Collection[Offer | str], span: Span) -> Iterator[Item]:
    for offer in offers:
        if isinstance(offer, str):
            yield from _entries(view, pos, language, offer, span)
        elif offer is Offer.FILES:
            yield from (
                Item(name, "file", "", span)
                for name in language.files(
                    view.file, view.ruleset, view.host, view.document.line(pos.line)[: span.start]
                )
            )
        elif offer is Offer.ENDS:
            yield from _ends(view, pos, language, span)
        else:
            yield from _symbols(view, pos, language, _SORTS[offer], span)
    constants = constants_of(view.dialect.name)
    if constants is not None and Offer.VARIABLES in offers:
        given = constants.names(view.file, view.ruleset.settings, view.host)
        yield from (Item(name, Sort.VARIABLE.value, "", span) for name in given)


def _ends(view: View, pos: Pos, language: Language, span: Span) -> Iterator[Item]:
    """The end of the innermost block that is open before a line."""
    found = view.document.around(pos.line, 0)
    if found is not None and (text := language.end(found[1])):
        yield Item(text, "keyword", f"line {found[0] + 1}", span)


def _entries(view: View, pos: Pos, language: Language, offer: str, span: Span) -> Iterator[Item]:
    """The names of a table, without what the line or the program can have once only."""
    table, _, name = offer.partition("/")
    taken = _sections(view, pos) if table == "section" else _taken(view, pos, span)
    for entry in view.dialect.codes.table(table):
        once = entry.name if table == "section" else entry.more.get("group") if table == "code" else None
        if name in ("", entry.name) and once not in taken and entry.name[:1].isalnum() | (table == "variable"):
            item = _entry(entry, language, span)
            yield from [item] if item.text and " " not in entry.name else []


def _taken(view: View, pos: Pos, span: Span) -> set[str]:
    """The modal groups of the other codes on a line."""
    codes = view.dialect.codes
    said = (
        each
        for each in on_line(view.document, pos.line)
        if each.symbol.sort is Sort.CODE and each.span.start != span.start
    )
    return {entry.more.get("group", "") for each in said if (entry := entry_of(each.symbol, codes)) is not None}


def _sections(view: View, pos: Pos) -> set[str]:
    """The sections that the program has on other lines."""
    found = set[str]()
    for symbol in all_symbols(view.document, Sort.SECTION) if view.is_read else ():
        placed = mentions_of(view.document, symbol, act=Act.DEFINE)
        found |= {symbol.name for each in placed if each.line != pos.line}
    return found


def _symbols(view: View, pos: Pos, language: Language, sort: Sort, span: Span) -> Iterator[Item]:
    """The names of a sort that mean something here: local ones of this region, others of all programs that belong together."""
    begun = view.document.line(pos.line)[slice(*span)]
    where = region(view.document, pos.line)
    own = locals_of(view.document, where) if view.is_read or where is not None else {}
    # What is being written is a name already, but one that nothing else names is not worth offering.
    placed = at(view.document, pos.line, pos.col)
    written = placed.mention.symbol if placed is not None else None
    mine = [each for each in own if each.sort is sort]
    if not view.is_read:
        # Others are offered when all of the program has been read.
        yield from (Item(language.written(each), sort.value, "", span) for each in sorted(mine) if each.name)
        return
    for each in related(view):
        for symbol in first_symbols(each.document, sort, begun, MOST, mine if each is view else ()):
            if not symbol.name or (sort in (Sort.LABEL, Sort.SECTION) and each is not view):
                continue
            if symbol == written and _once(each, symbol, own):
                continue
            text = symbol.name if sort in _BARE else language.written(symbol)
            yield Item(text, sort.value, "" if each is view else each.file.rpartition("/")[2], span)


def _once(view: View, symbol: Symbol, own: Mapping[Symbol, int]) -> bool:
    """Whether no two places name a symbol; ``own``: how often local ones are named."""
    if symbol.local:
        return own.get(symbol, 0) < 2
    return len(list(islice(mentions_of(view.document, symbol), 2))) < 2


def _entry(entry: Entry, language: Language, span: Span) -> Item:
    text = language.spelled(entry)
    return Item(text, entry.table, entry.title, span, entry.table, entry.name)
