"""How what is being written at a place is called: the signature of the function, command or directive, and which of its items comes next."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.definition import definitions
from deburr.symbols import language_of
from deburr.symbols.index import at

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.codes import Entry
    from deburr_grammar.text import Pos

_CALLED = re.compile(r"#?([A-Za-z_][A-Za-z0-9_]*)[ \t]*$")
_DIRECTIVE = re.compile(r"[ \t]*#([A-Za-z]+)[0-9]*(?=[ \t]|$)")
_TABLES = ("function", "command", "comment", "keyword")
_ITEM = re.compile(r"\|?[A-Za-z_][A-Za-z_0-9]*\|?")


class Signature(NamedTuple):
    """A signature, what it means, the columns of its items in it, and which of them comes next."""

    label: str
    text: str
    items: tuple[tuple[int, int], ...]
    active: int


def signature(view: View, pos: Pos) -> Signature | None:
    """The signature of what is being written at a place."""
    before = view.document.line(pos.line)[: pos.col]
    for opening, name in _open_calls(before):
        for table in _TABLES:
            entry = view.dialect.codes.entry(table, name)
            if entry is not None and entry.more.get("signature"):
                found = _of_call(view, pos, before) if table == "keyword" else None
                return found or _made(entry, _parted(entry, before[opening + 1 :]), True)
    return _of_call(view, pos, before) or _of_directive(view, before)


def _of_call(view: View, pos: Pos, before: str) -> Signature | None:
    """How a subprogram is called, read off the one that is called."""
    language = language_of(view.dialect.name)
    call = language.called(before) if language is not None else None
    placed = at(view.document, pos.line, call.col) if call is not None else None
    if language is None or call is None or placed is None:
        return None
    for spot in definitions(view, placed):
        other = view.beside(spot.file)
        if other is not None:
            takes = language.takes(other.document, call.symbol)
            return Signature(takes.label, takes.text, takes.items, min(call.given, max(0, len(takes.items) - 1)))
    return None


def _of_directive(view: View, before: str) -> Signature | None:
    directive = _DIRECTIVE.match(before)
    entry = view.dialect.codes.entry("keyword", directive[1]) if directive else None
    if directive is None or entry is None or not entry.more.get("signature"):
        return None
    rest = before[directive.end() :]
    return _made(entry, max(0, len(rest.split()) - (not rest.endswith((" ", "\t")))), False)


def _parted(entry: Entry, given: str) -> int:
    """How many items of a call stand before a place: what parts them is a comma, or `=` if the signature has one."""
    inside = str(entry.more["signature"]).partition("(")[2].partition(")")[0]
    return given.count(",") + ("=" in inside and "=" in given)


def _open_calls(before: str) -> Iterator[tuple[int, str]]:
    """The brackets that are open at the end of a text, innermost first, with the name before each."""
    depth = 0
    for col in range(len(before) - 1, -1, -1):
        if before[col] in ")]":
            depth += 1
        elif before[col] in "([":
            depth -= 1
            if depth < 0:
                depth = 0
                if called := _CALLED.search(before[:col]):
                    yield col, called[1]


def _made(entry: Entry, active: int, brackets: bool) -> Signature:
    label = str(entry.more["signature"])
    start = re.search(r"[(\[]", label) if brackets else re.search(r"[ \t]", label)
    first = start.end() if start else len(label)
    last = label.find(")", first) if brackets and ")" in label[first:] else len(label)
    items = tuple(match.span() for match in _ITEM.finditer(label, first, last))
    return Signature(label, entry.text, items, min(active, max(0, len(items) - 1)))
