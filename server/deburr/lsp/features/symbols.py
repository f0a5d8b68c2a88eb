"""The parts of programs: outline, folds, growing selections, names in the whole workspace."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

from lsprotocol import types

from deburr.finding import Place
from deburr.ide.folding import folds
from deburr.ide.outline import Part, outline
from deburr.ide.selection import selections
from deburr.ide.view import View
from deburr.lsp.convert import line_of
from deburr.lsp.server import Server, feature
from deburr.symbols import Sort

_KINDS = {
    Sort.SUB: types.SymbolKind.Function,
    Sort.SECTION: types.SymbolKind.Namespace,
    Sort.VARIABLE: types.SymbolKind.Variable,
    Sort.LABEL: types.SymbolKind.Event,
}
_MOST = 1_000


@feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
def on_document_symbols(
    server: Server, params: types.DocumentSymbolParams
) -> list[types.DocumentSymbol] | list[types.SymbolInformation]:
    """The outline of a program."""
    view = server.view(params.text_document.uri)
    parts = [] if view is None else outline(view)
    if server.client.hierarchy:
        return [_symbol(server, view, part) for part in parts] if view is not None else []
    return [_information(server, view, part) for part in _flat(parts)] if view is not None else []


@feature(types.WORKSPACE_SYMBOL)
async def on_workspace_symbols(server: Server, params: types.WorkspaceSymbolParams) -> list[types.SymbolInformation]:
    """The parts of all programs whose names hold what is asked for."""
    wanted, found = params.query.lower(), list[types.SymbolInformation]()
    for file in dict.fromkeys([*server.session.open_files, *server.session.programs()]):
        # A keystroke does not wait for the symbols of hundreds of files.
        await asyncio.sleep(0)
        view = server.session.view(file)
        for part in _flat(outline(view)) if view is not None else ():
            if wanted in part.name.lower() and view is not None:
                found.append(_information(server, view, part))
        if len(found) >= _MOST:
            break
    return found[:_MOST]


@feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
def on_folding(server: Server, params: types.FoldingRangeParams) -> list[types.FoldingRange]:
    """What can be folded away."""
    view = server.view(params.text_document.uri)
    kinds = types.FoldingRangeKind
    return [
        types.FoldingRange(each.first, each.last, kind=kinds.Comment if each.comment else kinds.Region)
        for each in (folds(view) if view is not None else ())
    ]


@feature(types.TEXT_DOCUMENT_SELECTION_RANGE)
def on_selection(server: Server, params: types.SelectionRangeParams) -> list[types.SelectionRange] | None:
    """What each cursor's selection grows to."""
    view = server.view(params.text_document.uri)
    if view is None:
        return None
    lines = line_of(view.document)
    found = []
    for position in params.positions:
        chain: types.SelectionRange | None = None
        for place in reversed(selections(view, server.units.pos(view.document, position))):
            chain = types.SelectionRange(server.units.place(lines, place), chain)
        found.append(chain or types.SelectionRange(types.Range(position, position)))
    return found


def _flat(parts: list[Part]) -> Iterator[Part]:
    for part in parts:
        yield part
        yield from _flat(part.parts)


def _symbol(server: Server, view: View, part: Part) -> types.DocumentSymbol:
    inner = [_symbol(server, view, each) for each in part.parts]
    lines = line_of(view.document)
    own = server.units.range(lines, part.first, part.span)
    return types.DocumentSymbol(part.name, _KINDS[part.sort], _whole(server, view, part), own, children=inner)


def _information(server: Server, view: View, part: Part) -> types.SymbolInformation:
    location = types.Location(server.session.uri(view.file), _whole(server, view, part))
    return types.SymbolInformation(location, part.name, _KINDS[part.sort])


def _whole(server: Server, view: View, part: Part) -> types.Range:
    last = view.document.line(part.last)
    return server.units.place(line_of(view.document), Place("", part.first, 0, part.last, len(last)))
