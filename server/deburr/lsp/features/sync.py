"""Documents that are opened, edited, saved and closed."""

from lsprotocol import types

from deburr.lsp.server import DEBUG, Server, feature
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos


@feature(types.TEXT_DOCUMENT_DID_OPEN)
def did_open(server: Server, params: types.DidOpenTextDocumentParams) -> None:
    """A document is the client's from now on."""
    said = params.text_document
    program = server.session.opened(said.uri, said.language_id, said.version, said.text)
    if program.view is None:
        server.log(f"{program.file}: {program.reason}", DEBUG)
    server.checks.opened(program)


@feature(types.TEXT_DOCUMENT_DID_CHANGE)
def did_change(server: Server, params: types.DidChangeTextDocumentParams) -> None:
    """A document was edited, perhaps at several places, one after the other."""
    program = server.program(params.text_document.uri)
    if program is None:
        return
    edits: list[Edit] = []
    for change in params.content_changes:
        document = program.document
        if isinstance(change, types.TextDocumentContentChangePartial):
            edits.append(server.session.units.edit(document, change))
            document = document.edit(edits[-1])
        else:
            end = document.offset(Pos(document.line_count, 0))
            edits.append(Edit(Pos(0, 0), end, change.text))
            document = Document.parse(change.text, document.dialect)
        server.session.take(program, document)
    program.version = params.text_document.version
    server.checks.edited(program, edits)


@feature(types.TEXT_DOCUMENT_DID_SAVE)
def did_save(server: Server, params: types.DidSaveTextDocumentParams) -> None:
    """A document was saved: it may be another dialect's now, by its modeline or by what is in it."""
    program = server.program(params.text_document.uri)
    if program is not None and server.session.settle(program):
        server.checks.opened(program)


@feature(types.TEXT_DOCUMENT_DID_CLOSE)
def did_close(server: Server, params: types.DidCloseTextDocumentParams) -> None:
    """A document is the disk's again."""
    program = server.program(params.text_document.uri)
    if program is not None:
        server.session.closed(program)
        server.checks.closed(program)
