"""What can be done about findings at the cursor."""

from lsprotocol import types

from deburr.ide.fixes import quick_fixes
from deburr.lsp.report import diagnostics
from deburr.lsp.server import Server, feature


@feature(types.TEXT_DOCUMENT_CODE_ACTION)
def on_actions(server: Server, params: types.CodeActionParams) -> list[types.CodeAction]:
    """What can be done about the findings on the chosen lines."""
    view = server.view(params.text_document.uri)
    only = params.context.only
    if view is None or (only and not any("quickfix".startswith(str(each)) for each in only)):
        return []
    first, last = params.range.start.line, params.range.end.line
    near = [each for each in server.checks.findings(view.file) if first <= each.place.line <= last]
    found = []
    for each in quick_fixes(view, near):
        said = server.protocol._converter.structure(diagnostics([each.finding], server.session), list[types.Diagnostic])
        edit = server.workspace_edit({view.file: each.edits})
        kind = types.CodeActionKind.QuickFix
        found.append(types.CodeAction(each.title, kind, said, is_preferred=each.preferred, edit=edit))
    return found
