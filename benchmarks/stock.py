"""`python -m benchmarks.stock`: a server as pygls' own examples have it, with its document store and a check of the whole text. For comparison only."""

from __future__ import annotations

import re

from lsprotocol import types
from pygls.lsp.server import LanguageServer
from pygls.workspace import TextDocument

SERVER = LanguageServer("stock", "1")
_SUB = re.compile(r"(?m)^[ \t]*o<(\w+)> sub")
_WORDS = ("sub", "endsub", "call", "if", "endif", "while", "endwhile")


def check(document: TextDocument) -> list[types.Diagnostic]:
    """Brackets that are not closed on their line: about the least that a check can say."""
    found = []
    for number, line in enumerate(document.lines):
        if line.count("[") != line.count("]"):
            place = types.Range(types.Position(number, 0), types.Position(number, len(line)))
            found.append(types.Diagnostic(place, "unbalanced brackets", types.DiagnosticSeverity.Error))
    return found


def publish(uri: str) -> None:
    """Check a document and say what was found."""
    document = SERVER.workspace.get_text_document(uri)
    found = types.PublishDiagnosticsParams(uri, check(document), document.version)
    SERVER.text_document_publish_diagnostics(found)


@SERVER.feature(types.TEXT_DOCUMENT_DID_OPEN)
def did_open(params: types.DidOpenTextDocumentParams) -> None:
    publish(params.text_document.uri)


@SERVER.feature(types.TEXT_DOCUMENT_DID_CHANGE)
def did_change(params: types.DidChangeTextDocumentParams) -> None:
    publish(params.text_document.uri)


@SERVER.feature(types.TEXT_DOCUMENT_HOVER)
def hover(params: types.HoverParams) -> types.Hover | None:
    document = SERVER.workspace.get_text_document(params.text_document.uri)
    word = document.word_at_position(params.position)
    return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, f"`{word}`")) if word else None


@SERVER.feature(types.TEXT_DOCUMENT_COMPLETION)
def completion(params: types.CompletionParams) -> list[types.CompletionItem]:
    document = SERVER.workspace.get_text_document(params.text_document.uri)
    return [types.CompletionItem(each) for each in (*_WORDS, *_SUB.findall(document.source))]


@SERVER.feature(types.TEXT_DOCUMENT_DEFINITION)
def definition(params: types.DefinitionParams) -> types.Location | None:
    document = SERVER.workspace.get_text_document(params.text_document.uri)
    word = document.word_at_position(params.position)
    for number, line in enumerate(document.lines):
        if line.lstrip().startswith(f"o<{word}> sub"):
            place = types.Position(number, 0)
            return types.Location(document.uri, types.Range(place, place))
    return None


if __name__ == "__main__":
    SERVER.start_io()
