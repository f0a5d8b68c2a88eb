"""Diagnostics for clients that ask for them: of a document, and of all programs in the folders."""

from lsprotocol import types
from pygls.exceptions import JsonRpcException

from deburr.lsp.checks import Outdated
from deburr.lsp.convert import uri_to_file
from deburr.lsp.progress import Progress
from deburr.lsp.report import Json, diagnostics, result_id
from deburr.lsp.server import Server, feature

SERVER_CANCELLED = -32802


@feature(types.TEXT_DOCUMENT_DIAGNOSTIC)
async def document_diagnostic(server: Server, params: types.DocumentDiagnosticParams) -> Json:
    """The diagnostics of a document, when all of it was gone through."""
    file = uri_to_file(params.text_document.uri)
    found = await _report(server, file, params.previous_result_id)
    if server.client.related_documents and (others := server.checks.elsewhere(file)):
        session = server.session
        found["relatedDocuments"] = {
            session.uri(other): _full(diagnostics(findings, session)) for other, findings in others.items()
        }
    return found


@feature(types.WORKSPACE_DIAGNOSTIC)
async def workspace_diagnostic(server: Server, params: types.WorkspaceDiagnosticParams) -> Json:
    """The diagnostics of all programs in the folders, and of those that are open besides."""
    before = {uri_to_file(each.uri): each.value for each in params.previous_result_ids}
    files = list(dict.fromkeys([*server.session.open_files, *server.session.programs()]))
    items: list[Json] = []
    with Progress(server.protocol, server.client, "Checking the workspace", params.work_done_token) as progress:
        for number, file in enumerate(files):
            progress.say(f"{number + 1:,} of {len(files):,}: {file.rpartition('/')[2]}", 100 * number // len(files))
            program = server.session.open_files.get(file)
            found = await _report(server, file, before.pop(file, None))
            items.append({"uri": server.session.uri(file), "version": program.version if program else None, **found})
            _handed_over(server, params.partial_result_token, items)
    items += [{"uri": server.session.uri(file), "version": None, **_full([])} for file in before]
    return {"items": items}


def _handed_over(server: Server, token: int | str | None, items: list[Json]) -> None:
    """Send what was found so far to a client that wants it in parts; then it is not part of the answer."""
    if token is not None:
        server.protocol.send({"method": types.PROGRESS, "params": {"token": token, "value": {"items": list(items)}}})
        items.clear()


async def _report(server: Server, file: str, known: str | None) -> Json:
    try:
        items = diagnostics(await server.checks.whole(file), server.session)
    except Outdated:
        raise _Retrigger from None
    found = _full(items)
    return {"kind": "unchanged", "resultId": known} if found["resultId"] == known else found


def _full(items: list[Json]) -> Json:
    return {"kind": "full", "resultId": result_id(items), "items": items}


class _Retrigger(JsonRpcException):
    """The document has changed since it was asked about."""

    CODE = SERVER_CANCELLED
    MESSAGE = "the document has changed"

    def __init__(self) -> None:
        super().__init__(self.MESSAGE, self.CODE, {"retriggerRequest": True})
