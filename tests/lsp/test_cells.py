"""All that an editor can show, in all dialects: every question that the server says it answers, asked over the wire of a server process, and the answer to the letter."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from deburr.lsp.capabilities import COMMANDS, capabilities
from deburr.lsp.client import client_of
from deburr.lsp.server import found_features
from deburr_grammar.dialects import NAMES, by_name
from support.asking import CAPABILITIES, QUESTIONS, Asking, answer, is_nothing
from support.cells import Cell, cells, diagnostic
from support.client import PUSHED, Client, Json

PUSH = "textDocument/publishDiagnostics"
TABLE = {dialect: list(cells(dialect)) for dialect in NAMES}


def named(dialect: str) -> list[object]:
    return [pytest.param(cell, id=f"{dialect}-{cell.row}") for cell in TABLE[dialect]]


class Session:
    """A server that has been started once, and what it says that it can do."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.client = Client(folder)
        self.offered: Json = self.client.start(CAPABILITIES, workspaceFolders=[])["capabilities"]
        self.number = 0


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    """One server for all cells: each has a folder of its own, which comes and goes."""
    found = Session(tmp_path_factory.mktemp("cells"))
    try:
        yield found
        assert found.client.stop() == 0
        assert "Traceback" not in found.client.logged()
    finally:
        found.client.kill()


def written(cell: Cell, folder: Path) -> None:
    for name, text in cell.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


@pytest.mark.parametrize("cell", [each for dialect in NAMES for each in named(dialect)])
def test_cell(cell: Cell, session: Session) -> None:
    session.number += 1
    folder = session.folder / str(session.number)
    folder.mkdir()
    written(cell, folder)
    changed = {"added": [{"uri": folder.as_uri(), "name": cell.row}], "removed": []}
    session.client.notify("workspace/didChangeWorkspaceFolders", {"event": changed})
    uri = (folder / f"main{by_name(cell.dialect).extensions[0]}").as_uri()
    try:
        said = pushed(cell, folder, uri) if cell.row == PUSH else asked(cell, session, folder, uri)
    finally:
        removed = {"added": [], "removed": changed["added"]}
        session.client.notify("workspace/didChangeWorkspaceFolders", {"event": removed})
    assert said == cell.answer
    assert is_nothing(said) == bool(cell.reason) or "would change" in cell.row


def asked(cell: Cell, session: Session, folder: Path, uri: str) -> str:
    session.client.open(uri, cell.text, cell.dialect)
    try:
        return answer(Asking(session.client, session.offered, cell, folder, uri))
    finally:
        session.client.close(uri)


def pushed(cell: Cell, folder: Path, uri: str) -> str:
    """What a client is told that does not ask: first of the program, then of the program without its last line, where nothing is wrong."""
    client = Client(folder)
    try:
        client.start(PUSHED)
        client.open(uri, cell.text, cell.dialect)
        found = client.pushed(uri, bool)
        start, end = cell.places
        client.change(uri, {"range": {"start": start, "end": end}, "text": ""})
        assert client.pushed(uri, lambda left: not left) == []
        assert client.stop() == 0
        return "\n".join(map(diagnostic, found))
    finally:
        client.kill()


@pytest.mark.parametrize("dialect", NAMES)
def test_each_cell_stands_once(dialect: str) -> None:
    assert sorted(cell.row for cell in TABLE[dialect]) == sorted([*QUESTIONS, PUSH])


def test_the_rows_are_what_the_server_offers() -> None:
    """Every method that is announced, every kind of action, every command; and none that is not."""
    told = {method for method, _ in found_features() if "/did" in method or method in ("initialized", "exit")}
    own = {method for method, _ in found_features() if method.startswith("deburr/")}
    asks = {method for method, _ in found_features()} - told - own
    assert {row.split(" ")[0] for row in QUESTIONS} == asks
    offered = capabilities(client_of({"capabilities": CAPABILITIES}))
    for method, provided in (
        ("textDocument/codeAction", offered["codeActionProvider"]["codeActionKinds"]),
        ("workspace/executeCommand", COMMANDS),
    ):
        assert {row.split(" ")[1] for row in QUESTIONS if row.split(" ")[0] == method} == set(provided)
