"""Colours by meaning: which stretch of a line is what. Looks at no more lines than it is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.symbols import Act, Mention, Sort
from deburr.symbols.index import on_line
from deburr_grammar.tree import tokens

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.text import Span

_TYPES = {
    Sort.VARIABLE: "variable",
    Sort.SUB: "function",
    Sort.LABEL: "label",
    Sort.SECTION: "namespace",
    Sort.FILE: "string",
    Sort.CODE: "macro",
    Sort.WORD: "property",
    Sort.FUNCTION: "method",
    Sort.KEYWORD: "keyword",
}
_MODIFIERS = {Act.DEFINE: "declaration", Act.SET: "modification"}


class Coloured(NamedTuple):
    """A stretch of a line, its type, and its modifier, "" for none."""

    line: int
    start: int
    end: int
    type: str
    modifier: str


def coloured(view: View, first: int, last: int) -> Iterator[Coloured]:
    """The coloured stretches of some lines, both included, from left to right, none on another."""
    for line in range(max(first, 0), min(last, view.document.line_count - 1) + 1):
        reached = 0
        for each in sorted(_of_line(view, line), key=lambda found: (found.start, -found.end)):
            if each.start >= reached:
                reached = each.end
                yield each


def _of_line(view: View, line: int) -> Iterator[Coloured]:
    node = view.document.node(line)
    mentions = [each for each in on_line(view.document, line) if each.symbol.name]
    yield from (_mention(line, each) for each in mentions)
    taken = [each.span for each in mentions]
    if "COMMENT" in " ".join(node.kinds) or "NUMBER" in node.kinds or "SEMICOLON_COMMENT" in node.kinds:
        for token in tokens(node.tree):
            kind = "comment" if "COMMENT" in token.kind else "number" if token.kind == "NUMBER" else ""
            if kind and not _inside(token.start, taken):
                yield Coloured(line, token.start, token.end, kind, "")


def _mention(line: int, mention: Mention) -> Coloured:
    symbol, act, span = mention.symbol, mention.act, mention.span
    return Coloured(line, span.start, span.end, _TYPES[symbol.sort], _MODIFIERS.get(act, ""))


def _inside(col: int, spans: list[Span]) -> bool:
    return any(span.start <= col < span.end for span in spans)
