"""What can be written at the cursor, and how what is being written is called."""

from lsprotocol import types

from deburr.ide.completion import MOST, completions, resolved
from deburr.ide.signature import signature
from deburr.lsp.report import Json
from deburr.lsp.server import Server, feature
from deburr_grammar.dialects import NAMES, by_name

_KINDS = {
    "variable": types.CompletionItemKind.Variable,
    "subprogram": types.CompletionItemKind.Function,
    "function": types.CompletionItemKind.Function,
    "label": types.CompletionItemKind.Reference,
    "section": types.CompletionItemKind.Module,
    "file": types.CompletionItemKind.File,
    "code": types.CompletionItemKind.Operator,
    "word": types.CompletionItemKind.Property,
}


@feature(types.TEXT_DOCUMENT_COMPLETION)
def on_completion(server: Server, params: types.CompletionParams) -> Json | None:
    """What can be written at the cursor."""
    spot = server.spot(params)
    if spot is None:
        return None
    dialect, items = spot.view.dialect.name, completions(*spot)
    place: Json | None = None
    found = []
    for number, each in enumerate(items):
        place = place or server.json_range(spot.view, spot.pos.line, each.span)
        item: Json = {"label": each.text, "kind": _KINDS.get(each.sort, types.CompletionItemKind.Keyword).value}
        item |= {"sortText": f"{number:05}", "textEdit": {"newText": each.text, "range": place}}
        item |= {"detail": each.detail} if each.detail else {}
        item |= {"data": [dialect, each.table, each.name]} if each.table else {}
        found.append(item)
    # Of a program with more names than are offered, others are offered as more is written.
    return {"isIncomplete": len(found) >= MOST, "items": found}


@feature(types.COMPLETION_ITEM_RESOLVE)
def on_resolve(server: Server, item: types.CompletionItem) -> types.CompletionItem:
    """All that is known of an item."""
    dialect, table, name = item.data if isinstance(item.data, list) and len(item.data) == 3 else ("", "", "")
    if dialect in NAMES and (text := resolved(by_name(dialect), str(table), str(name))):
        item.documentation = types.MarkupContent(types.MarkupKind.Markdown, text)
    return item


@feature(types.TEXT_DOCUMENT_SIGNATURE_HELP)
def on_signature(server: Server, params: types.SignatureHelpParams) -> types.SignatureHelp | None:
    """How what is being written is called."""
    spot = server.spot(params)
    found = None if spot is None else signature(*spot)
    if found is None:
        return None
    items = [types.ParameterInformation(each) for each in found.items]
    said = types.MarkupContent(types.MarkupKind.PlainText, found.text) if found.text else None
    return types.SignatureHelp(
        [types.SignatureInformation(found.label, said, items)], 0, found.active if items else None
    )
