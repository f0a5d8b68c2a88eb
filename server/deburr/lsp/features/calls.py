"""Who calls what."""

from collections.abc import Callable

from lsprotocol import types

from deburr.finding import Place
from deburr.ide import calls
from deburr.ide.view import View
from deburr.lsp.convert import uri_to_file
from deburr.lsp.server import Server, feature
from deburr.symbols import Sort

_Direction = Callable[[View, calls.Routine], list[calls.Calls]]
_Other = tuple[types.CallHierarchyItem, list[types.Range]]
_KINDS = {
    Sort.SUB: types.SymbolKind.Function,
    Sort.SECTION: types.SymbolKind.Namespace,
    Sort.FILE: types.SymbolKind.File,
}


@feature(types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY)
def on_prepare_calls(server: Server, params: types.CallHierarchyPrepareParams) -> list[types.CallHierarchyItem] | None:
    """What is called at the cursor, or the routine that it stands in."""
    spot = server.spot(params)
    return None if spot is None else [_item(server, spot.view, each) for each in calls.prepared(*spot)]


@feature(types.CALL_HIERARCHY_INCOMING_CALLS)
def on_incoming(
    server: Server, params: types.CallHierarchyIncomingCallsParams
) -> list[types.CallHierarchyIncomingCall]:
    """Who calls a routine."""
    found = _found(server, params.item, calls.incoming)
    return [types.CallHierarchyIncomingCall(item, ranges) for item, ranges in found]


@feature(types.CALL_HIERARCHY_OUTGOING_CALLS)
def on_outgoing(
    server: Server, params: types.CallHierarchyOutgoingCallsParams
) -> list[types.CallHierarchyOutgoingCall]:
    """Whom a routine calls."""
    found = _found(server, params.item, calls.outgoing)
    return [types.CallHierarchyOutgoingCall(item, ranges) for item, ranges in found]


def _found(server: Server, item: types.CallHierarchyItem, of: _Direction) -> list[_Other]:
    """The routines at the other end of calls, with the places of these."""
    view = _view(server, item)
    if view is None:
        return []
    found = of(view, _routine(server, view, item))
    return [
        (_item(server, view, each.routine), [server.location(spot).range for spot in each.places]) for each in found
    ]


def _item(server: Server, view: View, routine: calls.Routine) -> types.CallHierarchyItem:
    """A routine for the client. A snippet need not tell its language by itself, so a program of the same goes with it."""
    lines = server.session.lines(routine.file)
    whole = Place("", routine.first, 0, routine.last, len(lines(routine.last)))
    return types.CallHierarchyItem(
        name=routine.name,
        kind=_KINDS[routine.sort],
        uri=server.session.uri(routine.file),
        range=server.units.place(lines, whole),
        selection_range=server.units.range(lines, routine.line, routine.span),
        detail="" if routine.whole else routine.file.rpartition("/")[2],
        data={"whole": routine.whole, "like": server.session.uri(view.file)},
    )


def _view(server: Server, item: types.CallHierarchyItem) -> View | None:
    """The program of an item."""
    like = server.view(str(item.data.get("like", ""))) if isinstance(item.data, dict) else None
    return server.view(item.uri) if like is None else like.beside(uri_to_file(item.uri))


def _routine(server: Server, view: View, item: types.CallHierarchyItem) -> calls.Routine:
    """The routine of an item as the program is now."""
    if isinstance(item.data, dict) and item.data.get("whole"):
        return calls.whole(view)
    return calls.around(view, server.units.pos(view.document, item.selection_range.start).line)
