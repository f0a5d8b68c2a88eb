"""What is shown in and above lines: links to files, counts of calls, what words stand for; and labels that change together."""

from lsprotocol import types

from deburr.ide.hints import hints
from deburr.ide.lenses import lenses
from deburr.ide.linked import linked
from deburr.ide.links import links
from deburr.lsp.convert import line_of
from deburr.lsp.server import Server, feature
from deburr.lsp.settings import HINTS, LENSES
from deburr_grammar.text import Pos


@feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
def on_links(server: Server, params: types.DocumentLinkParams) -> list[types.DocumentLink]:
    """Names that lead to files."""
    view = server.view(params.text_document.uri)
    if view is None:
        return []
    lines = line_of(view.document)
    return [
        types.DocumentLink(server.units.range(lines, each.line, each.span), server.session.uri(each.file))
        for each in links(view)
    ]


@feature(types.TEXT_DOCUMENT_CODE_LENS)
def on_lenses(server: Server, params: types.CodeLensParams) -> list[types.CodeLens]:
    """The way to the flat program, and how often each part is called."""
    uri = params.text_document.uri
    view, shown = server.view(uri), server.session.settings.shown
    if view is None:
        return []
    lines, start = line_of(view.document), types.Position(0, 0)
    found = []
    if shown(LENSES, "expand"):
        command = types.Command("Expand", "deburr.expand", arguments=[{"uri": uri}])
        found.append(types.CodeLens(types.Range(start, start), command))
    for each in lenses(view) if shown(LENSES, "calls") else ():
        title = f"{each.calls} call{'' if each.calls == 1 else 's'}"
        found.append(types.CodeLens(server.units.range(lines, each.line, each.span), types.Command(title, "")))
    return found


@feature(types.TEXT_DOCUMENT_INLAY_HINT)
def on_hints(server: Server, params: types.InlayHintParams) -> list[types.InlayHint]:
    """What words stand for."""
    view = server.view(params.text_document.uri)
    if view is None:
        return []
    lines = line_of(view.document)
    return [
        types.InlayHint(server.units.position(lines, Pos(each.line, each.col)), each.text)
        for each in hints(view, params.range.start.line, params.range.end.line)
        if server.session.settings.shown(HINTS, each.kind)
    ]


@feature(types.TEXT_DOCUMENT_LINKED_EDITING_RANGE)
def on_linked(server: Server, params: types.LinkedEditingRangeParams) -> types.LinkedEditingRanges | None:
    """Labels that change together."""
    spot = server.spot(params)
    found = [] if spot is None else linked(*spot)
    if spot is None or not found:
        return None
    lines = line_of(spot.view.document)
    return types.LinkedEditingRanges([server.units.range(lines, each.line, each.span) for each in found])
