"""Who calls what."""

from lsprotocol import types

from deburr.finding import Place
from deburr.ide import calls
from deburr.ide.view import View
from deburr.lsp.server import Server, feature
from deburr.symbols import Sort

_KINDS = {
    Sort.SUB: types.SymbolKind.Function,
    Sort.SECTION: types.SymbolKind.Namespace,
    Sort.FILE: types.SymbolKind.File,
}


@feature(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
def on_prepare_calls(server: Server, params: types.CallHierarchyPrepareParams) -> list[types.CallHierarchyItem] | None:
    """What is called at the cursor, or the routine that it stands in."""
    spot = server.spot(params)
    return None if spot is None else [_item(server, each) for each in calls.prepared(*spot)]


@feature(types.CALL_HIERARCHY_INCOMING_CALLS)
def on_incoming(
    server: Server, params: types.CallHierarchyIncomingCallsParams
) -> list[types.CallHierarchyIncomingCall]:
    """Who calls a routine."""
    view = server.view(params.item.uri)
    found = [] if view is None else calls.incoming(view, _routine(server, view, params.item))
    return [
        types.CallHierarchyIncomingCall(
            _item(server, each.routine), [server.location(spot).range for spot in each.places]
        )
        for each in found
    ]


@feature(types.CALL_HIERARCHY_OUTGOING_CALLS)
def on_outgoing(
    server: Server, params: types.CallHierarchyOutgoingCallsParams
) -> list[types.CallHierarchyOutgoingCall]:
    """Whom a routine calls."""
    view = server.view(params.item.uri)
    found = [] if view is None else calls.outgoing(view, _routine(server, view, params.item))
    return [
        types.CallHierarchyOutgoingCall(
            _item(server, each.routine), [server.location(spot).range for spot in each.places]
        )
        for each in found
    ]


def _item(server: Server, routine: calls.Routine) -> types.CallHierarchyItem:
    lines = server.session.lines(routine.file)
    whole = Place("", routine.first, 0, routine.last, len(lines(routine.last)))
    return types.CallHierarchyItem(
        name=routine.name,
        kind=_KINDS[routine.sort],
        uri=server.session.uri(routine.file),
        range=server.units.place(lines, whole),
        selection_range=server.units.range(lines, routine.line, routine.span),
        detail="" if routine.whole else routine.file.rpartition("/")[2],
        data={"whole": routine.whole},
    )


def _routine(server: Server, view: View, item: types.CallHierarchyItem) -> calls.Routine:
    """The routine of an item as the program is now."""
    if isinstance(item.data, dict) and item.data.get("whole"):
        return calls.whole(view)
    return calls.around(view, server.units.pos(view.document, item.selection_range.start).line)
