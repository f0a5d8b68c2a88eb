"""Layout of programs, of lines that are chosen, and of lines as they are typed."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from lsprotocol import types

from deburr.formatting.style import Style, style_of
from deburr.ide.formatting import Lines, formatting, typed
from deburr.lsp.server import Server, feature
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.lsp.report import Json
    from deburr_grammar.text import Edit


@feature(types.TEXT_DOCUMENT_FORMATTING)
async def on_document(server: Server, params: types.DocumentFormattingParams) -> list[Json] | None:
    """Lay out a program."""
    return await _laid_out(server, params, None)


@feature(types.TEXT_DOCUMENT_RANGE_FORMATTING)
async def on_range(server: Server, params: types.DocumentRangeFormattingParams) -> list[Json] | None:
    """Lay out the lines of a range."""
    return await _laid_out(server, params, [_lines(params.range)])


@feature(types.TEXT_DOCUMENT_RANGES_FORMATTING)
async def on_ranges(server: Server, params: types.DocumentRangesFormattingParams) -> list[Json] | None:
    """Lay out the lines of several ranges."""
    return await _laid_out(server, params, [_lines(each) for each in params.ranges])


@feature(types.TEXT_DOCUMENT_ON_TYPE_FORMATTING)
def on_type(server: Server, params: types.DocumentOnTypeFormattingParams) -> list[Json]:
    """Indent what was typed."""
    spot = server.spot(params)
    if spot is None:
        return []
    return _said(server, spot.view, typed(spot.view, _style(server, spot.view, params.options), spot.pos, params.ch))


async def _laid_out(server: Server, params: Any, wanted: Sequence[Lines] | None) -> list[Json] | None:
    """Work between messages; an edit makes it start again with what is there then."""
    uri = params.text_document.uri
    while (view := server.view(uri)) is not None:
        found: list[Json] = []
        for edits in formatting(view, _style(server, view, params.options), wanted):
            found += _said(server, view, edits)
            await asyncio.sleep(0)
            if server.view(uri) is not view:
                break
        else:
            return found
    return None


def _lines(chosen: types.Range) -> Lines:
    """The lines that a range reaches into: one that ends at the start of a line does not."""
    end = chosen.end.line
    return chosen.start.line, end - 1 if end > chosen.start.line and not chosen.end.character else end


def _style(server: Server, view: View, options: types.FormattingOptions) -> Style:
    editor = " " * options.tab_size if options.insert_spaces else "\t"
    return style_of(server.session.settings.of(view.file), editor)


def _said(server: Server, view: View, edits: Sequence[Edit]) -> list[Json]:
    return [
        {"range": server.json_range(view, edit.start.line, Span(edit.start.col, edit.end.col)), "newText": edit.text}
        for edit in edits
    ]
