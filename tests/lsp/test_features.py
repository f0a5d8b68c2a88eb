"""Every method that the server offers, asked as a client asks: positions in the client's units, open buffers, other files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types

from deburr.lsp.capabilities import capabilities
from deburr.lsp.client import Client
from deburr.lsp.server import found_features
from support.inside import Inside

SMILE = "(😋) "
"""One code point, two units of UTF-16, four of UTF-8; in a comment, so it means nothing."""
UNITS = {"utf-8": 4, "utf-16": 2, "utf-32": 1}
RICH: dict[str, Any] = {
    "textDocument": {
        "documentSymbol": {"hierarchicalDocumentSymbolSupport": True},
        "diagnostic": {},
        "completion": {},
        "semanticTokens": {},
    },
    "workspace": {"textDocumentContent": {}, "workspaceEdit": {"documentChanges": True}},
}
TEXT = f"o<s> sub\n#<deep>=1\n{SMILE}G1 X[#<deep>] F1\no<s> endsub\no<s> call\nM2\n"


class Opened:
    """A server with one document open, and requests about places in it."""

    def __init__(self, inside: Inside, uri: str, shift: int) -> None:
        self.inside = inside
        self.uri = uri
        self.shift = shift

    def ask(self, method: str, line: int | None = None, col: int = 0, **more: Any) -> Any:
        """A request about a place; columns behind the smile are given as if it had one unit."""
        params: dict[str, Any] = {"textDocument": {"uri": self.uri}, **more}
        if line is not None:
            params["position"] = {"line": line, "character": col}
        return self.inside.request(f"textDocument/{method}", params)


def opened(inside: Inside, text: str = TEXT, language: str = "rs274", encoding: str = "utf-16") -> Opened:
    inside.open("untitled:one", text, language)
    return Opened(inside, "untitled:one", UNITS[encoding] - 1)


def span(found: Any) -> tuple[int, int, int]:
    """A range of one line."""
    assert found["start"]["line"] == found["end"]["line"]
    return found["start"]["line"], found["start"]["character"], found["end"]["character"]


def test_what_is_offered_is_there_and_the_other_way_round() -> None:
    offered = capabilities(Client(pulls=True, content=True))
    methods = {method for method, _ in found_features()}
    assert len(methods) == len(found_features())
    by_provider = {
        "diagnosticProvider": {types.TEXT_DOCUMENT_DIAGNOSTIC, types.WORKSPACE_DIAGNOSTIC},
        "hoverProvider": {types.TEXT_DOCUMENT_HOVER},
        "completionProvider": {types.TEXT_DOCUMENT_COMPLETION, types.COMPLETION_ITEM_RESOLVE},
        "signatureHelpProvider": {types.TEXT_DOCUMENT_SIGNATURE_HELP},
        "definitionProvider": {types.TEXT_DOCUMENT_DEFINITION},
        "declarationProvider": {types.TEXT_DOCUMENT_DECLARATION},
        "referencesProvider": {types.TEXT_DOCUMENT_REFERENCES},
        "documentHighlightProvider": {types.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT},
        "renameProvider": {types.TEXT_DOCUMENT_RENAME, types.TEXT_DOCUMENT_PREPARE_RENAME},
        "documentSymbolProvider": {types.TEXT_DOCUMENT_DOCUMENT_SYMBOL},
        "workspaceSymbolProvider": {types.WORKSPACE_SYMBOL},
        "foldingRangeProvider": {types.TEXT_DOCUMENT_FOLDING_RANGE},
        "selectionRangeProvider": {types.TEXT_DOCUMENT_SELECTION_RANGE},
        "documentFormattingProvider": {types.TEXT_DOCUMENT_FORMATTING},
        "documentRangeFormattingProvider": {
            types.TEXT_DOCUMENT_RANGE_FORMATTING,
            types.TEXT_DOCUMENT_RANGES_FORMATTING,
        },
        "documentOnTypeFormattingProvider": {types.TEXT_DOCUMENT_ON_TYPE_FORMATTING},
        "codeActionProvider": {types.TEXT_DOCUMENT_CODE_ACTION, types.CODE_ACTION_RESOLVE},
        "semanticTokensProvider": {
            types.TEXT_DOCUMENT_SEMANTIC_TOKENS_RANGE,
            types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL,
            types.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL_DELTA,
        },
        "documentLinkProvider": {types.TEXT_DOCUMENT_DOCUMENT_LINK},
        "codeLensProvider": {types.TEXT_DOCUMENT_CODE_LENS, types.CODE_LENS_RESOLVE},
        "inlayHintProvider": {types.TEXT_DOCUMENT_INLAY_HINT},
        "linkedEditingRangeProvider": {types.TEXT_DOCUMENT_LINKED_EDITING_RANGE},
        "callHierarchyProvider": {
            types.TEXT_DOCUMENT_PREPARE_CALL_HIERARCHY,
            types.CALL_HIERARCHY_INCOMING_CALLS,
            types.CALL_HIERARCHY_OUTGOING_CALLS,
        },
        "executeCommandProvider": {types.WORKSPACE_EXECUTE_COMMAND},
    }
    assert {name for name in offered if name.endswith("Provider")} == set(by_provider)
    told = {each for each in methods if "did" in each or each in (types.INITIALIZED, types.EXIT)}
    content = {types.WORKSPACE_TEXT_DOCUMENT_CONTENT}
    # Whoever asks for what the protocol does not have knows deburr, and need not be offered it.
    own = {each for each in methods if each.startswith("deburr/")}
    assert methods - told - content - own == set().union(*by_provider.values())
    assert "diagnosticProvider" not in capabilities(Client())
    assert "textDocumentContent" not in capabilities(Client())["workspace"]


@pytest.mark.parametrize("encoding", UNITS)
def test_places_are_in_the_clients_units(encoding: str) -> None:
    """A name behind a character that is one column, and one, two or four units."""
    with Inside({**RICH, "general": {"positionEncodings": [encoding]}}) as inside:
        document = opened(inside, encoding=encoding)
        col = 10 + document.shift
        hover = document.ask("hover", 2, col)
        assert span(hover["range"]) == (2, 9 + document.shift, 16 + document.shift)
        assert hover["contents"]["value"].startswith("**`#<deep>`**")
        (definition,) = document.ask("definition", 2, col)
        assert span(definition["range"]) == (1, 2, 6)
        assert document.ask("declaration", 2, col) == [definition]
        places = document.ask("references", 2, col, context={"includeDeclaration": True})
        assert [span(each["range"]) for each in places] == [(1, 2, 6), (2, 11 + document.shift, 15 + document.shift)]
        marks = document.ask("documentHighlight", 2, col)
        assert [(span(each["range"])[0], each["kind"]) for each in marks] == [(1, 3), (2, 2)]
        prepared = document.ask("prepareRename", 2, col)
        assert (span(prepared["range"])[1], prepared["placeholder"]) == (11 + document.shift, "deep")
        (edit,) = document.ask("rename", 2, col, newName="depth")["documentChanges"]
        assert edit["textDocument"] == {"uri": document.uri, "version": 1}
        assert [span(each["range"]) for each in edit["edits"]] == [span(each["range"]) for each in places]


def test_a_rename_that_is_refused_says_why() -> None:
    with Inside(RICH) as inside:
        document = opened(inside)
        assert "nothing here has a name" in document.ask("prepareRename", 5, 0)["message"]
        assert "shared by all" in document.ask("rename", 1, 3, newName="_x")["message"]


def test_edits_without_versions_for_clients_that_know_none() -> None:
    with Inside() as inside:
        found = opened(inside).ask("rename", 1, 3, newName="y")
        assert list(found["changes"]) == ["untitled:one"]


def test_the_shape_of_a_program() -> None:
    with Inside(RICH) as inside:
        document = opened(inside)
        (symbol,) = document.ask("documentSymbol")
        assert (symbol["name"], symbol["range"]["end"]["line"]) == ("s", 3)
        assert document.ask("foldingRange") == [{"startLine": 0, "endLine": 3, "kind": "region"}]
        (grown,) = document.ask("selectionRange", positions=[{"line": 1, "character": 3}])
        sizes = []
        while grown is not None:
            sizes.append(grown["range"]["end"]["line"])
            grown = grown.get("parent")
        assert sizes == sorted(sizes)
        assert sizes[-1] == 6


def test_a_flat_outline_for_clients_that_know_no_other(tmp_path: Path) -> None:
    (tmp_path / "other.ngc").write_text("o<lathe> sub\no<lathe> endsub\n")
    with Inside(workspaceFolders=[{"uri": tmp_path.as_uri(), "name": "x"}]) as inside:
        document = opened(inside)
        (symbol,) = document.ask("documentSymbol")
        assert symbol["location"]["uri"] == document.uri
        (found,) = inside.request("workspace/symbol", {"query": "LATH"})
        assert found["location"]["uri"] == (tmp_path / "other.ngc").as_uri()
        assert len(inside.request("workspace/symbol", {"query": ""})) == 2


def test_colours_of_all_of_a_part_and_of_what_changed() -> None:
    with Inside(RICH) as inside:
        document = opened(inside)
        full = document.ask("semanticTokens/full")
        assert len(full["data"]) % 5 == 0
        start, end = {"line": 0, "character": 0}, {"line": 99, "character": 0}
        assert document.ask("semanticTokens/range", range={"start": start, "end": end})["data"] == full["data"]
        unchanged = document.ask("semanticTokens/full/delta", previousResultId=full["resultId"])
        assert unchanged["edits"] == []
        change = {"range": {"start": start, "end": start}, "text": "G0\n"}
        said = {"textDocument": {"uri": document.uri, "version": 2}, "contentChanges": [change]}
        inside.notify("textDocument/didChange", said)
        delta = document.ask("semanticTokens/full/delta", previousResultId=full["resultId"])
        data = list(full["data"])
        for each in delta["edits"]:
            data[each["start"] : each["start"] + each["deleteCount"]] = each["data"]
        assert data == document.ask("semanticTokens/full")["data"]
        assert "data" in document.ask("semanticTokens/full/delta", previousResultId="never")


def test_a_long_program_is_coloured_in_parts() -> None:
    with Inside(RICH) as inside:
        document = opened(inside, "G1 X1\n" * 6_000)
        assert document.ask("semanticTokens/full") is None
        part = {"start": {"line": 5_990, "character": 0}, "end": {"line": 5_995, "character": 0}}
        # Of the last line nothing is in that range.
        assert len(document.ask("semanticTokens/range", range=part)["data"]) == 5 * 3 * 5


def test_writing() -> None:
    with Inside(RICH) as inside:
        document = opened(inside, f"{SMILE}G1 X[SI\n")
        first = document.ask("completion", 0, 12)["items"][0]
        assert first["textEdit"] == {"newText": "SIN[", "range": {"start": {"line": 0, "character": 10}, "end": {"line": 0, "character": 12}}}  # fmt: skip
        assert "Sine" in inside.request("completionItem/resolve", first)["documentation"]["value"]
        assert inside.request("completionItem/resolve", {"label": "x", "data": 7}) == {"label": "x", "data": 7}
        inside.open("untitled:two", "@LINE\n#EVAL(#V1=MAX(1,\n@\n", "cgt")
        at = {"textDocument": {"uri": "untitled:two"}, "position": {"line": 1, "character": 16}}
        found = inside.request("textDocument/signatureHelp", at)
        assert (found["signatures"][0]["label"], found["activeParameter"]) == ("MAX(a, b)", 1)


def test_code_actions() -> None:
    with Inside(RICH) as inside:
        document = opened(inside, "#IFF1 |a| EqualTo 1 n\n#ENDIF1\n", "metagcode")
        inside.settle()
        line = {"start": {"line": 0, "character": 0}, "end": {"line": 0, "character": 5}}
        found = document.ask("codeAction", range=line, context={"diagnostics": []})
        assert [each["title"] for each in found] == ["Change to `#IF1`", "Allow `metagcode.unknown-directive` here"]
        assert found[0]["diagnostics"][0]["code"] == "metagcode.unknown-directive"
        (edit,) = found[0]["edit"]["documentChanges"][0]["edits"]
        assert (span(edit["range"]), edit["newText"]) == ((0, 0, 5), "#IF1")
        assert document.ask("codeAction", range=line, context={"diagnostics": [], "only": ["refactor"]}) == []
        assert len(document.ask("codeAction", range=line, context={"diagnostics": [], "only": ["quickfix"]})) == 2


def test_what_is_no_program_is_answered_with_nothing() -> None:
    with Inside(RICH) as inside:
        inside.open("untitled:letter", "Dear Sir,\n", "plaintext")
        at = {"textDocument": {"uri": "untitled:letter"}, "position": {"line": 0, "character": 1}}
        assert inside.request("textDocument/hover", at) is None
        assert inside.request("textDocument/completion", at) is None
        assert inside.request("textDocument/definition", at) == []
        assert inside.request("textDocument/documentSymbol", at) == []
        assert inside.request("textDocument/hover", {**at, "textDocument": {"uri": "file:///no/such.ngc"}}) is None


def test_the_page_of_a_rule_is_a_document() -> None:
    with Inside(RICH) as inside:
        page = inside.request("workspace/textDocumentContent", {"uri": "deburr-rule:/rs274.comment-nested.md"})["text"]
        assert page.startswith("# rs274.comment-nested (error)")
        assert inside.request("workspace/textDocumentContent", {"uri": "deburr-rule:/no.such.md"})["text"] == ""


def test_commands_that_are_none_are_refused() -> None:
    with Inside(RICH) as inside:
        for command, arguments in (("deburr.nonsense", [{"uri": "x"}]), ("deburr.expand", []), ("deburr.expand", [7])):
            found = inside.request("workspace/executeCommand", {"command": command, "arguments": arguments})
            assert found["code"] == -32602
        document = opened(inside)
        said = {"command": "deburr.explainDialect", "arguments": [{"uri": document.uri}]}
        answer = inside.request("workspace/executeCommand", said)
        assert (answer["reason"], answer["title"], answer["profile"]) == (
            "the editor's language",
            "RS274/NGC",
            "linuxcnc",
        )
        assert answer["takes"] == ["blockDelete", "machineValues", "keepN", "decimals"]


@pytest.mark.parametrize(
    ("name", "dialect", "takes"),
    [
        ("a.cgt", "cgt", ["input"]),
        ("a.mgc", "metagcode", ["decimals"]),
        ("a.z32", "z32", ["blockDelete", "keepN", "decimals"]),
    ],
)
def test_an_editor_can_ask_what_an_expansion_takes(tmp_path: Path, name: str, dialect: str, takes: list[str]) -> None:
    (tmp_path / name).write_text("M30\n")
    with Inside(RICH) as inside:
        said = {"command": "deburr.explainDialect", "arguments": [{"uri": (tmp_path / name).as_uri()}]}
        answer = inside.request("workspace/executeCommand", said)
    assert (answer["dialect"], answer["takes"], answer["profile"]) == (dialect, takes, None)
