"""A session as a real client library holds it, with its own idea of the protocol: every answer is read into its types."""

from __future__ import annotations

import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient

TEXTS = {
    "rs274": "o<s> sub\n#<deep>=1\nG1 X[#<deep>] F1\no<s> endsub\nG21 G90 G17\no<s> call\nM2\n",
    "metagcode": "#LOOP1 |Depth| 5 c\nZ|Depth|\n#ENDLOOP1\n",
    "cgt": "@DECLARE\n#DEC #depth\n@\n@LINE\nX#depth\n@\n",
    "z32": "(P)\n!HA=1!\nX<HA>\nM30\n",
}
PLACES = {"rs274": (2, 8), "metagcode": (1, 3), "cgt": (4, 4), "z32": (2, 3)}


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[sys.executable, "-m", "deburr", "server", "--stdio"]))
async def client(lsp_client: LanguageClient, tmp_path: Path) -> AsyncIterator[None]:
    folders = [types.WorkspaceFolder(tmp_path.as_uri(), "here")]
    capabilities = pytest_lsp.client_capabilities("visual-studio-code")
    registered: list[types.RegistrationParams] = []

    @lsp_client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def on_register(params: types.RegistrationParams) -> None:
        registered.append(params)

    params = types.InitializeParams(capabilities=capabilities, workspace_folders=folders)
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
    uri = (tmp_path / f"program.{dialect}").as_uri()
    item = types.TextDocumentItem(uri, dialect, 1, TEXTS[dialect])
    client.text_document_did_open(types.DidOpenTextDocumentParams(item))
    document = types.TextDocumentIdentifier(uri)
    position = types.Position(*PLACES[dialect])
    hover = await client.text_document_hover_async(types.HoverParams(document, position))
    assert isinstance(hover, types.Hover)
    assert isinstance(hover.contents, types.MarkupContent)
    assert "set in line" in hover.contents.value or "defined in line" in hover.contents.value
    definition = await client.text_document_definition_async(types.DefinitionParams(document, position))
    assert isinstance(definition, list)
    assert len(definition) == 1
    context = types.ReferenceContext(include_declaration=True)
    references = await client.text_document_references_async(types.ReferenceParams(context, document, position))
    assert references is not None
    assert len(references) == 2
    completion = await client.text_document_completion_async(types.CompletionParams(document, position))
    assert isinstance(completion, types.CompletionList)
    assert completion.items
    resolved = await client.completion_item_resolve_async(completion.items[-1])
    assert resolved.label == completion.items[-1].label
    assert await client.text_document_document_symbol_async(types.DocumentSymbolParams(document)) is not None
    assert await client.text_document_folding_range_async(types.FoldingRangeParams(document)) is not None
    tokens = await client.text_document_semantic_tokens_full_async(types.SemanticTokensParams(document))
    assert tokens is not None
    assert tokens.data
    report = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(document))
    assert isinstance(report, types.RelatedFullDocumentDiagnosticReport)
    rename = await client.text_document_rename_async(types.RenameParams(document, position, _other(dialect)))
    assert rename is not None


def _other(dialect: str) -> str:
    return {"rs274": "depth", "metagcode": "Width", "cgt": "width", "z32": "HB"}[dialect]
