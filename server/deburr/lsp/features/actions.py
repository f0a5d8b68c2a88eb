"""What can be done at the cursor: about findings, about all of them, and with the program. What costs more than a line is worked out when it is chosen."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable, Iterator, Sequence
from contextlib import closing
from typing import TYPE_CHECKING, Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from deburr.ide.create import missing_file
from deburr.ide.fixes import quick_fixes
from deburr.ide.refactor import Cannot, NewFile
from deburr.ide.refactorings import FIX_ALL, Offer, Rebuilt, everything, offers, rebuilding, rebuilt
from deburr.lsp.idle import driven
from deburr.lsp.progress import Progress
from deburr.lsp.report import diagnostics
from deburr.lsp.server import Server, feature
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr.ide.view import View

_REFUSED, _MODIFIED = -32803, -32801
_SMALL = 2_000
"""Lines up to which what could be done is worked out at once for a client that cannot ask for it later."""
_QUICK = types.CodeActionKind.QuickFix.value


@feature(types.TEXT_DOCUMENT_CODE_ACTION)
def on_actions(server: Server, params: types.CodeActionParams) -> list[types.CodeAction]:
    """What can be done about the findings on the chosen lines, and with these lines."""
    view, uri = server.view(params.text_document.uri), params.text_document.uri
    if view is None:
        return []
    only = [getattr(each, "value", each) for each in params.context.only or ()]
    found: list[types.CodeAction] = []
    if _wanted(_QUICK, only):
        first, last = params.range.start.line, params.range.end.line
        near = server.checks.on(view.file, first, last)
        found += [*_quick(server, view, near), *_created(server, view, near)]
    start, end = (server.units.pos(view.document, each) for each in (params.range.start, params.range.end))
    could = [each for each in (*offers(view, start, end), everything()) if _wanted(each.kind, only)]
    at_once = not server.client.resolves_actions
    if at_once and not only:
        could = [] if view.document.line_count > _SMALL else [each for each in could if each.kind != FIX_ALL]
    for offer in could:
        data = {"uri": uri, "version": _version(server, uri), "name": offer.name, "range": [*start, *end]}
        found += (
            _now(server, view, offer, start, end) if at_once else [types.CodeAction(offer.title, offer.kind, data=data)]
        )
    return found


@feature(types.CODE_ACTION_RESOLVE)
async def on_resolve(server: Server, action: types.CodeAction) -> types.CodeAction:
    """The edit of what was chosen, proven. It is worked out between other messages; an edit of the program ends it."""
    data: Any = action.data if isinstance(action.data, dict) else {}
    uri, place = data.get("uri"), data.get("range")
    view = server.view(uri) if isinstance(uri, str) else None
    if view is None or not isinstance(place, list) or [type(each) for each in place] != [int] * 4:
        return action
    try:
        found = await _worked_out(server, view, data, (Pos(*place[:2]), Pos(*place[2:])), action.title)
        action.edit = _edit(server, view, found)
    except Cannot as why:
        raise JsonRpcException(f"not done: {why}", _REFUSED) from None
    return action


async def _worked_out(server: Server, view: View, data: Any, place: tuple[Pos, Pos], title: str) -> Rebuilt:
    with (
        Progress(server.protocol, server.client, title) as progress,
        closing(rebuilding(view, str(data.get("name")), *place)) as work,
    ):
        while data.get("version") == _version(server, data["uri"]):
            try:
                driven(work)
            except StopIteration as done:
                found: Rebuilt = done.value
                return found
            progress.say("proving that the program means the same")
            await asyncio.sleep(0)
    raise JsonRpcException("the program has changed since this was offered", _MODIFIED)


def _wanted(kind: str, only: Sequence[str]) -> bool:
    """Whether a client wants a kind: all, if it names none; else those that it names and their sorts."""
    return not only or any(kind == each or kind.startswith(f"{each}.") for each in only)


def _version(server: Server, uri: str) -> int | None:
    program = server.program(uri)
    return None if program is None else program.version


def _quick(server: Server, view: View, near: Iterable[Finding]) -> Iterator[types.CodeAction]:
    for each in quick_fixes(view, near):
        edit = server.workspace_edit({view.file: each.edits})
        yield types.CodeAction(each.title, _QUICK, _said(server, each.finding), is_preferred=each.preferred, edit=edit)


def _created(server: Server, view: View, near: Iterable[Finding]) -> Iterator[types.CodeAction]:
    """Files that are missing, for clients that can make any."""
    for finding in near if server.client.creates else ():
        if new := missing_file(view, finding):
            title = f"Create `{new.file.rpartition('/')[2]}`"
            yield types.CodeAction(title, _QUICK, _said(server, finding), edit=_with_file(server, {}, new))


def _said(server: Server, finding: Finding) -> Sequence[types.Diagnostic]:
    found: list[types.Diagnostic] = server.protocol._converter.structure(
        diagnostics([finding], server.session), list[types.Diagnostic]
    )
    return found


def _now(server: Server, view: View, offer: Offer, start: Pos, end: Pos) -> Iterator[types.CodeAction]:
    """What was asked for is worked out at once; what cannot be done is not offered."""
    try:
        edit = _edit(server, view, rebuilt(view, offer.name, start, end))
    except Cannot:
        return
    yield types.CodeAction(offer.title, offer.kind, edit=edit)


def _edit(server: Server, view: View, found: Rebuilt) -> types.WorkspaceEdit:
    if found.file is None:
        return server.workspace_edit({view.file: found.edits})
    if not server.client.creates:
        raise Cannot("the editor cannot make the file that it needs")
    return _with_file(server, {view.file: found.edits}, found.file)


def _with_file(server: Server, edits: dict[str, tuple[Edit, ...]], new: NewFile) -> types.WorkspaceEdit:
    """Edits, and before them a new file with its text."""
    uri = server.session.uri(new.file)
    start = types.Range(types.Position(0, 0), types.Position(0, 0))
    text = types.TextDocumentEdit(
        types.OptionalVersionedTextDocumentIdentifier(uri, None), [types.TextEdit(start, new.text)]
    )
    made = types.CreateFile(uri, options=types.CreateFileOptions(ignore_if_exists=True))
    rest = server.workspace_edit(edits).document_changes or []
    return types.WorkspaceEdit(document_changes=[made, *([text] if new.text else []), *rest])
