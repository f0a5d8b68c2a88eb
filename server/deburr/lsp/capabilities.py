"""What the server can do, as JSON: a function of the client. Imports nothing large, because the answer must not wait for imports."""

from typing import Any

from deburr import __version__
from deburr.lsp.client import Client

COMMANDS = ("deburr.expand", "deburr.sourceMap", "deburr.plot", "deburr.explainDialect")
EXPANDED = "deburr-expanded"
"""The scheme of flat programs."""
PAGES = "deburr-rule"
"""The scheme of the rules' manual pages."""
SHOW_REFERENCES = "deburr.showReferences"
"""A command of the client's, if it says that it has it: the arguments are a URI, a position and the locations to show."""
TOKEN_TYPES = (
    "variable",
    "function",
    "label",
    "namespace",
    "string",
    "macro",
    "property",
    "method",
    "keyword",
    "comment",
    "number",
)
TOKEN_MODIFIERS = ("declaration", "modification")

_PROVIDERS: dict[str, Any] = {
    "hoverProvider": True,
    "completionProvider": {"triggerCharacters": ["#", "|", "<", "@", "!", "[", "("], "resolveProvider": True},
    "signatureHelpProvider": {"triggerCharacters": ["(", "[", ",", " ", "="]},
    "definitionProvider": True,
    "declarationProvider": True,
    "referencesProvider": True,
    "documentHighlightProvider": True,
    "renameProvider": {"prepareProvider": True},
    "documentSymbolProvider": True,
    "workspaceSymbolProvider": True,
    "foldingRangeProvider": True,
    "selectionRangeProvider": True,
    "documentFormattingProvider": True,
    "documentRangeFormattingProvider": {"rangesSupport": True},
    "documentOnTypeFormattingProvider": {
        "firstTriggerCharacter": "\n",
        # With these the words end that end blocks or part them, in letters of either case.
        "moreTriggerCharacter": list("bBeEfFpPtT"),
    },
    "codeActionProvider": {
        "codeActionKinds": [
            "quickfix",
            "refactor.extract",
            "refactor.inline",
            "refactor.rewrite",
            "source.fixAll.deburr",
        ],
        "resolveProvider": True,
    },
    "semanticTokensProvider": {
        "legend": {"tokenTypes": list(TOKEN_TYPES), "tokenModifiers": list(TOKEN_MODIFIERS)},
        "range": True,
        "full": {"delta": True},
    },
    "documentLinkProvider": {"resolveProvider": False},
    "codeLensProvider": {"resolveProvider": True},
    "inlayHintProvider": {"resolveProvider": False},
    "linkedEditingRangeProvider": True,
    "callHierarchyProvider": True,
    "executeCommandProvider": {"commands": list(COMMANDS), "workDoneProgress": True},
}


def answer(client: Client) -> dict[str, Any]:
    """The result of `initialize`."""
    return {"capabilities": capabilities(client), "serverInfo": {"name": "deburr", "version": __version__}}


def capabilities(client: Client) -> dict[str, Any]:
    """The capabilities of the server for a client."""
    workspace: dict[str, Any] = {"workspaceFolders": {"supported": True, "changeNotifications": True}}
    if client.content:
        workspace["textDocumentContent"] = {"schemes": [EXPANDED, PAGES]}
    diagnostics = {
        "identifier": "deburr",
        "interFileDependencies": True,
        "workspaceDiagnostics": True,
        "workDoneProgress": True,
    }
    return {
        "positionEncoding": client.encoding,
        "textDocumentSync": {"openClose": True, "change": 2, "save": {"includeText": False}},
        "workspace": workspace,
        **({"diagnosticProvider": diagnostics} if client.pulls else {}),
        **_PROVIDERS,
    }
