"""How what is being written at a place is called: the signature of the function, command or directive, and which of its items comes next."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

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
                return _made(entry, before[opening + 1 :].count(","), True)
    directive = _DIRECTIVE.match(before)
    entry = view.dialect.codes.entry("keyword", directive[1]) if directive else None
    if directive is None or entry is None or not entry.more.get("signature"):
        return None
    rest = before[directive.end() :]
    return _made(entry, max(0, len(rest.split()) - (not rest.endswith((" ", "\t")))), False)


def _open_calls(before: str) -> Iterator[tuple[int, str]]:
    """The brackets that are open at the end of a text, innermost first, with the name before each."""
    depth = 0
    for at in range(len(before) - 1, -1, -1):
        if before[at] in ")]":
            depth += 1
        elif before[at] in "([":
            depth -= 1
            if depth < 0:
                depth = 0
                if called := _CALLED.search(before[:at]):
                    yield at, called[1]


def _made(entry: Entry, active: int, brackets: bool) -> Signature:
    label = str(entry.more["signature"])
    start = re.search(r"[(\[]", label) if brackets else re.search(r"[ \t]", label)
    items = tuple(match.span() for match in _ITEM.finditer(label, start.end() if start else len(label)))
    return Signature(label, entry.text, items, min(active, max(0, len(items) - 1)))
