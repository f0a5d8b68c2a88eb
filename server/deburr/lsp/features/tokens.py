"""Colours by meaning: of what is seen always, of the whole only where that is quick."""

from __future__ import annotations

from itertools import count
from typing import Any

from lsprotocol import types

from deburr.ide.tokens import coloured
from deburr.ide.view import View
from deburr.lsp.capabilities import TOKEN_MODIFIERS, TOKEN_TYPES
from deburr.lsp.server import Server, feature

LONGEST = 5_000
"""Lines up to which all colours are given at once; of a longer program those of a range."""
_KEPT = 32
_numbers = count(1)


@feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE)
def on_range(server: Server, params: types.SemanticTokensRangeParams) -> types.SemanticTokens:
    """The colours of some lines."""
    view, end = server.view(params.text_document.uri), params.range.end
    # What ends before a line's first sign does not hold that line.
    last = end.line if end.character else end.line - 1
    return types.SemanticTokens([] if view is None else _data(server, view, params.range.start.line, last))


@feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL)
def on_full(server: Server, params: types.SemanticTokensParams) -> types.SemanticTokens | None:
    """The colours of a program that is not too long."""
    view = server.view(params.text_document.uri)
    if view is None or view.document.line_count > LONGEST:
        return None
    return _named(server, _data(server, view, 0, view.document.line_count))


@feature(types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA)
def on_delta(server: Server, params: types.SemanticTokensDeltaParams) -> Any:
    """What is different since the colours that the client has."""
    view = server.view(params.text_document.uri)
    if view is None or view.document.line_count > LONGEST:
        return None
    before = server.coloured.get(params.previous_result_id)
    found = _named(server, _data(server, view, 0, view.document.line_count))
    return found if before is None else types.SemanticTokensDelta(_edits(before, list(found.data)), found.result_id)


def _named(server: Server, data: list[int]) -> types.SemanticTokens:
    name = str(next(_numbers))
    server.coloured[name] = data
    while len(server.coloured) > _KEPT:
        del server.coloured[next(iter(server.coloured))]
    return types.SemanticTokens(data, name)


def _edits(before: list[int], after: list[int]) -> list[types.SemanticTokensEdit]:
    """One edit: all between the common start and the common end."""
    shorter = min(len(before), len(after))
    start = next((at for at in range(shorter) if before[at] != after[at]), shorter)
    end = next((at for at in range(shorter - start) if before[-1 - at] != after[-1 - at]), shorter - start)
    if start == len(before) == len(after):
        return []
    return [types.SemanticTokensEdit(start, len(before) - start - end, after[start : len(after) - end])]


def _data(server: Server, view: View, first: int, last: int) -> list[int]:
    """Five numbers a stretch, its place counted from the one before it."""
    data: list[int] = []
    line = start = 0
    text, at = "", -1
    for each in coloured(view, first, last):
        if each.line != at:
            text, at = view.document.line(each.line), each.line
        begin, end = (server.units.col_to_units(text, col) for col in (each.start, each.end))
        start = start if each.line == line else 0
        modifier = 1 << TOKEN_MODIFIERS.index(each.modifier) if each.modifier else 0
        data += (each.line - line, begin - start, end - begin, TOKEN_TYPES.index(each.type), modifier)
        line, start = each.line, begin
    return data
