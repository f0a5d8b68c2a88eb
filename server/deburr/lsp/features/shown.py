"""What is shown in and above lines: links to files, counts of calls, what words stand for; and labels that change together."""

from lsprotocol import types

from deburr.ide.hints import KINDS, hints
from deburr.ide.lenses import callers, lenses
from deburr.ide.linked import linked
from deburr.ide.links import links
from deburr.lsp.capabilities import SHOW_REFERENCES
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
    """The way to the flat program, where each part is called, how often loops go round. Calls are counted when a lens is seen."""
    uri = params.text_document.uri
    view = server.view(uri)
    if view is None:
        return []
    lines, start = line_of(view.document), types.Position(0, 0)
    config, found = server.session.settings.of(view.file), list[types.CodeLens]()
    if config.shows(LENSES, "expand"):
        command = types.Command("Expand", "deburr.expand", arguments=[{"uri": uri}])
        found.append(types.CodeLens(types.Range(start, start), command))
    for each in lenses(view):
        if config.shows(LENSES, each.kind):
            place = server.units.range(lines, each.line, each.span)
            counted = types.Command(each.text, "") if each.text else None
            found.append(types.CodeLens(place, counted, None if counted else {"uri": uri}))
    return found


@feature(types.CODE_LENS_RESOLVE)
def on_lens_resolve(server: Server, lens: types.CodeLens) -> types.CodeLens:
    """How often what is defined there is called, and where, for clients that can show that."""
    uri = str(lens.data["uri"]) if isinstance(lens.data, dict) and "uri" in lens.data else ""
    view = server.view(uri) if uri else None
    if view is None or lens.command is not None:
        return lens
    at = server.units.pos(view.document, lens.range.start)
    places = [server.location(each) for each in callers(view, at)]
    title = f"{len(places)} reference{'' if len(places) == 1 else 's'}"
    command = SHOW_REFERENCES if places and SHOW_REFERENCES in server.client.commands else ""
    lens.command = types.Command(title, command, arguments=[uri, lens.range.start, places] if command else None)
    return lens


@feature(types.TEXT_DOCUMENT_INLAY_HINT)
def on_hints(server: Server, params: types.InlayHintParams) -> list[types.InlayHint]:
    """What words stand for, and what is known of values and loops."""
    view = server.view(params.text_document.uri)
    if view is None:
        return []
    lines, config = line_of(view.document), server.session.settings.of(view.file)
    kinds = [kind for kind in KINDS if config.shows(HINTS, kind)]
    found = hints(view, params.range.start.line, params.range.end.line, kinds)
    return [
        types.InlayHint(
            server.units.position(lines, Pos(each.line, each.col)), each.text, padding_left=each.kind == "passes"
        )
        for each in found
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
