"""Where names lead and where they are used."""

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from deburr.ide.definition import definition
from deburr.ide.highlight import highlights
from deburr.ide.references import references
from deburr.ide.rename import Cannot, prepared, renamed
from deburr.ide.view import Spot
from deburr.lsp.convert import line_of
from deburr.lsp.server import Server, feature

REFUSED = -32803


@feature(types.TEXT_DOCUMENT_DEFINITION)
def on_definition(server: Server, params: types.DefinitionParams) -> list[types.Location]:
    """Where a name leads."""
    spot = server.spot(params)
    return [] if spot is None else [server.location(each) for each in definition(*spot)]


@feature(types.TEXT_DOCUMENT_DECLARATION)
def on_declaration(server: Server, params: types.DeclarationParams) -> list[types.Location]:
    """The same: there are no two sorts of places."""
    spot = server.spot(params)
    return [] if spot is None else [server.location(each) for each in definition(*spot)]


@feature(types.TEXT_DOCUMENT_REFERENCES)
def on_references(server: Server, params: types.ReferenceParams) -> list[types.Location]:
    """Where a name is used."""
    spot = server.spot(params)
    wanted = params.context.include_declaration
    found: list[Spot] = [] if spot is None else references(*spot, definitions=wanted)
    return [server.location(each) for each in found]


@feature(types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT)
def on_highlight(server: Server, params: types.DocumentHighlightParams) -> list[types.DocumentHighlight]:
    """What belongs to the place at the cursor."""
    spot = server.spot(params)
    if spot is None:
        return []
    kinds = types.DocumentHighlightKind
    kind = {True: kinds.Write, False: kinds.Read, None: kinds.Text}
    lines = line_of(spot.view.document)
    found = highlights(*spot)
    return [
        types.DocumentHighlight(server.units.range(lines, each.line, each.span), kind[each.writes]) for each in found
    ]


@feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
def on_prepare(server: Server, params: types.PrepareRenameParams) -> types.PrepareRenamePlaceholder | None:
    """What can be renamed at the cursor."""
    spot = server.spot(params)
    if spot is None:
        return None
    try:
        span, name = prepared(*spot)
    except Cannot as why:
        raise JsonRpcException(str(why), REFUSED) from None
    place = server.units.range(line_of(spot.view.document), spot.pos.line, span)
    return types.PrepareRenamePlaceholder(range=place, placeholder=name)


@feature(types.TEXT_DOCUMENT_RENAME)
def on_rename(server: Server, params: types.RenameParams) -> types.WorkspaceEdit | None:
    """Another name, in all files."""
    spot = server.spot(params)
    if spot is None:
        return None
    try:
        return server.workspace_edit({each.file: each.edits for each in renamed(*spot, params.new_name)})
    except Cannot as why:
        raise JsonRpcException(str(why), REFUSED) from None
