"""Names in a program that stand for files, and the files."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.definition import file_of
from deburr.symbols import Act
from deburr.symbols.index import all_symbols, mentions_of

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.text import Span


class Link(NamedTuple):
    """A name, where it stands, and the file that it means."""

    line: int
    span: Span
    file: str


def links(view: View) -> list[Link]:
    """All names that lead to files, in order. What the program defines itself leads nowhere else."""
    found = []
    for symbol in all_symbols(view.document):
        file = file_of(view, symbol)
        if file is None or file == view.file:
            continue
        placed = list(mentions_of(view.document, symbol))
        if not any(each.mention.act is Act.DEFINE for each in placed):
            found += [Link(each.line, each.mention.inner, file) for each in placed if each.mention.act is Act.CALL]
    return sorted(found)
