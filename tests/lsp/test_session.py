"""A session as a real client library holds it, with its own idea of the protocol: every answer is read into its types."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient

from deburr_grammar.dialects import by_name

TEXTS = {
    "rs274": "o<s> sub\n#<deep>=1\nG1 X[#<deep>] F1\no<s> endsub\nG21 G90 G17\no<s> call [1]\no<far> call\no1 repeat [1+1]\no1 endrepeat\nM2\n",
    "metagcode": "#LOOP1 |Depth| 5 c\nZ|Depth|\n#ENDLOOP1\n#FILE part\n#IF1 |Depth| equalto 1 n\n#ENDIF1\n",
    "cgt": "@DECLARE\n#DEC #depth\n@\n@LINE\n#EVAL(#depth=1)X#depth\n#CALL(SUB)\n#EVAL(#MOV=2)\n@\n@SUB\nX\n@\n",
    "z32": "(P)\n!HA=1!\nG1 X<HA>\n!GON10!\nN10\nG25YZX\nAA1\n!GOP5!\n!:L254-A!\nM30\n:5\nG26\n",
}
"""Programs in which every question has an answer."""
PLACES = {"rs274": (2, 8), "metagcode": (1, 3), "cgt": (4, 21), "z32": (2, 5)}
"""A variable that is set once and read once."""
CALLED = {"rs274": (5, 3, 2), "metagcode": (3, 8, 1), "cgt": (5, 7, 1), "z32": (7, 5, 1)}
"""A call, and how many routines stand at its two ends together."""
HELPED = {"rs274": (5, 11), "metagcode": (4, 8), "cgt": (4, 14)}
"""Places in what has a signature; functions have one in every dialect, but not every program has one."""
LINKED = {"rs274": (7, 2), "metagcode": (0, 6)}
LAID_OUT = {"rs274": ["    #<deep> = ", "    "], "metagcode": [], "cgt": [], "z32": []}
"""What takes the place of the blanks and words that differ."""
TYPED = {"rs274": ["    ", "    "], "metagcode": [], "cgt": [], "z32": []}
FILES = {
    "rs274": {"far.ngc": "o<far> sub\no<far> endsub\n"},
    "metagcode": {"Snippets/part": "G1\n"},
    "cgt": {},
    "z32": {"root/A.z32": "G26\n"},
}


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[sys.executable, "-m", "deburr", "server", "--stdio"]))
async def client(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    folders = [types.WorkspaceFolder(tmp_path.as_uri(), "here")]
    capabilities = pytest_lsp.client_capabilities("visual-studio-code")
    registered: list[types.RegistrationParams] = []

    @lsp_client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def on_register(params: types.RegistrationParams) -> None:
        registered.append(params)

    options = {"z32": {"file-root": str(tmp_path / "root")}}
    params = types.InitializeParams(
        capabilities=capabilities, workspace_folders=folders, initialization_options=options
    )

    await lsp_client.initialize_session(params)
    yield
    assert [each.method for each in registered[0].registrations] == [
        types.WORKSPACE_DID_CHANGE_WATCHED_FILES,
        types.WORKSPACE_DID_CHANGE_CONFIGURATION,
    ]
    await lsp_client.shutdown_session()


@pytest.mark.parametrize("dialect", TEXTS)
@pytest.mark.asyncio
async def test_every_question_in_every_language(client: LanguageClient, tmp_path: Path, dialect: str) -> None:
    uri = (tmp_path / f"program{by_name(dialect).extensions[0]}").as_uri()
    for name, text in FILES[dialect].items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    item = types.TextDocumentItem(uri, dialect, 1, TEXTS[dialect])
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    asked = Asked(client, dialect, types.TextDocumentIdentifier(uri))
    await asked.about_a_variable()
    await asked.about_the_program()
    await asked.about_calls()
    await asked.about_lines()
    await asked.about_layout()
    await asked.about_colours()
    await asked.about_writing()
    await asked.about_the_flat_program()


class Asked:
    """The questions about one document, by what they are about."""

    def __init__(self, client: LanguageClient, dialect: str, document: types.TextDocumentIdentifier) -> None:
        self._client = client
        self._dialect = dialect
        self._document = document
        self._position = types.Position(*PLACES[dialect])
        self._all = types.Range(types.Position(0, 0), types.Position(99, 0))

    async def about_a_variable(self) -> None:
        client, document, position = self._client, self._document, self._position
        hover = await client.text_document_hover_async(types.HoverParams(document, position))
        assert isinstance(hover, types.Hover)
        assert isinstance(hover.contents, types.MarkupContent)
        assert "set in line" in hover.contents.value
        assert "value here" in hover.contents.value
        definition = await client.text_document_definition_async(types.DefinitionParams(document, position))
        declaration = await client.text_document_declaration_async(types.DeclarationParams(document, position))
        assert isinstance(definition, list)
        assert len(definition) == 1
        assert declaration == definition
        context = types.ReferenceContext(include_declaration=True)
        references = await client.text_document_references_async(types.ReferenceParams(context, document, position))
        assert references is not None
        marks = await client.text_document_document_highlight_async(types.DocumentHighlightParams(document, position))
        assert marks is not None
        known = {"rs274": 2, "metagcode": 3, "cgt": 3, "z32": 2}[self._dialect]
        assert (len(references), len(marks)) == (known, known)
        prepared = await client.text_document_prepare_rename_async(types.PrepareRenameParams(document, position))
        assert isinstance(prepared, types.PrepareRenamePlaceholder)
        other = {"rs274": "depth", "metagcode": "Width", "cgt": "width", "z32": "HB"}[self._dialect]
        rename = await client.text_document_rename_async(types.RenameParams(document, position, other))
        assert rename is not None

    async def about_the_program(self) -> None:
        client, document = self._client, self._document
        symbols = await client.text_document_document_symbol_async(types.DocumentSymbolParams(document))
        assert symbols
        found = await client.workspace_symbol_async(types.WorkspaceSymbolParams(""))
        assert found
        folds = await client.text_document_folding_range_async(types.FoldingRangeParams(document))
        assert folds
        grown = await client.text_document_selection_range_async(types.SelectionRangeParams(document, [self._position]))
        assert grown is not None
        assert grown[0].parent is not None
        report = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(document))
        assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
        again = types.DocumentDiagnosticParams(document, previous_result_id=report.result_id)
        same = await client.text_document_diagnostic_async(again)
        assert isinstance(same, types.RelatedUnchangedDocumentDiagnosticReport)
        everywhere = await client.workspace_diagnostic_async(types.WorkspaceDiagnosticParams([]))
        assert document.uri in [each.uri for each in everywhere.items]
        context = types.CodeActionContext(diagnostics=report.items)
        actions = await client.text_document_code_action_async(types.CodeActionParams(document, self._all, context))
        assert actions is not None

    async def about_calls(self) -> None:
        client, (line, col, ends) = self._client, CALLED[self._dialect]
        position = types.Position(line, col)
        prepared = await client.text_document_prepare_call_hierarchy_async(
            types.CallHierarchyPrepareParams(self._document, position)
        )
        assert prepared is not None
        (item,) = prepared
        incoming = await client.call_hierarchy_incoming_calls_async(types.CallHierarchyIncomingCallsParams(item))
        assert incoming is not None
        assert len(incoming) == 1
        caller = incoming[0].from_
        outgoing = await client.call_hierarchy_outgoing_calls_async(types.CallHierarchyOutgoingCallsParams(caller))
        assert outgoing is not None
        assert item.name in [each.to.name for each in outgoing]
        assert len(outgoing) == {"rs274": 2, "z32": 2}.get(self._dialect, 1)
        assert ends

    async def about_lines(self) -> None:
        client, document = self._client, self._document
        lenses = await client.text_document_code_lens_async(types.CodeLensParams(document))
        assert lenses
        resolved = [await client.code_lens_resolve_async(each) for each in lenses]
        assert all(each.command is not None and each.command.title for each in resolved)
        hints = await client.text_document_inlay_hint_async(types.InlayHintParams(document, self._all))
        assert hints is not None
        assert bool(hints) is (self._dialect != "metagcode")
        links = await client.text_document_document_link_async(types.DocumentLinkParams(document))
        assert links is not None
        assert len(links) == len(FILES[self._dialect])
        linked = await client.text_document_linked_editing_range_async(
            types.LinkedEditingRangeParams(document, types.Position(*LINKED.get(self._dialect, (0, 0))))
        )
        assert (linked is not None) is (self._dialect in LINKED)

    async def about_layout(self) -> None:
        client, document = self._client, self._document
        options = types.FormattingOptions(tab_size=4, insert_spaces=True)
        whole = await client.text_document_formatting_async(types.DocumentFormattingParams(document, options))
        assert whole is not None
        assert [each.new_text for each in whole] == LAID_OUT[self._dialect]
        ranged = types.DocumentRangeFormattingParams(document, self._all, options)
        assert await client.text_document_range_formatting_async(ranged) == whole
        several = types.DocumentRangesFormattingParams(document, [self._all, self._all], options)
        assert await client.text_document_ranges_formatting_async(several) == whole
        typed = types.DocumentOnTypeFormattingParams(document, types.Position(2, 0), "\n", options)
        indented = await client.text_document_on_type_formatting_async(typed)
        assert indented is not None
        assert [each.new_text for each in indented] == TYPED[self._dialect]

    async def about_colours(self) -> None:
        client, document = self._client, self._document
        full = await client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(document))
        assert full is not None
        assert full.data
        assert full.result_id is not None
        part = await client.text_document_semantic_tokens_range_async(
            types.SemanticTokensRangeParams(document, self._all)
        )
        assert part is not None
        assert list(part.data) == list(full.data)
        delta = await client.text_document_semantic_tokens_full_delta_async(
            types.SemanticTokensDeltaParams(document, full.result_id)
        )
        assert isinstance(delta, types.SemanticTokensDelta)
        assert list(delta.edits) == []

    async def about_writing(self) -> None:
        client, document, position = self._client, self._document, self._position
        completion = await client.text_document_completion_async(types.CompletionParams(document, position))
        assert isinstance(completion, types.CompletionList)
        assert completion.items
        resolved = await client.completion_item_resolve_async(completion.items[-1])
        assert resolved.label == completion.items[-1].label
        help_at = types.Position(*HELPED.get(self._dialect, (0, 0)))
        signature = await client.text_document_signature_help_async(types.SignatureHelpParams(document, help_at))
        assert (signature is not None) is (self._dialect in HELPED)

    async def about_the_flat_program(self) -> None:
        client, uri = self._client, self._document.uri
        argument = {"uri": uri, "define": {"Depth": "10"} if self._dialect == "metagcode" else {}}
        command = types.ExecuteCommandParams("deburr.expand", [argument])
        flat = await client.workspace_execute_command_async(command)
        # A template needs a toolpath.
        assert bool(flat["text"]) is (self._dialect != "cgt"), flat["findings"]
        place = types.ExecuteCommandParams("deburr.sourceMap", [{**argument, "position": {"line": 2, "character": 0}}])
        there = await client.workspace_execute_command_async(place)
        assert there["uri"].startswith("deburr-expanded:")
        content = await client.workspace_text_document_content_async(types.TextDocumentContentParams(there["uri"]))
        assert content.text == ("" if self._dialect == "metagcode" else flat["text"])
        explained = types.ExecuteCommandParams("deburr.explainDialect", [{"uri": uri}])
        assert (await client.workspace_execute_command_async(explained))["dialect"] == self._dialect
