"""Whatever a client sends, right or wrong: an answer or a proper error, no crash, nothing stale afterwards."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from deburr.lsp.server import found_features
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.text import Edit, Pos
from support.client import PULLS, Client, edit
from support.inside import Inside
from support.model import Model

TEXTS = {
    "rs274": "o<s> sub\n#<deep>=1\nG1 X[#<deep>] F1\no<s> endsub\nG21 G90 G17\no<s> call\nM2\n",
    "metagcode": "#LOOP1 |Depth| 5 c\nZ|Depth|\n#ENDLOOP1\n",
    "cgt": "@DECLARE\n#DEC #depth\n@\n@LINE\nX#depth#CALL(SUB)\n@\n@SUB\n@\n",
    "z32": "(P)\nG25YZX\n!HA=1!\nN10 X<HA> AA1\n!GON10!\nM30\n",
}
RICH: dict[str, Any] = {
    "textDocument": {"diagnostic": {}},
    "workspace": {"textDocumentContent": {}, "diagnostics": {"refreshSupport": True}},
    "window": {"workDoneProgress": True},
}
TOLD = {method for method, _ in found_features() if "/did" in method or method in ("initialized", "exit")}
ASKED = sorted({method for method, _ in found_features()} - TOLD)
PLACE = {"line": 1, "character": 2}
VAST = {"line": 2**31 - 1, "character": 2**31 - 1}


def complete(method: str, uri: str, at: dict[str, int]) -> dict[str, Any]:
    """The parameters of every request at once; each takes what it needs. Only a command has a `command` that is a name."""
    found = every(uri, at)
    if method != "workspace/executeCommand":
        del found["command"]
    return found


def every(uri: str, at: dict[str, int]) -> dict[str, Any]:
    stretch = {"start": at, "end": VAST}
    item = {"name": "x", "kind": 12, "uri": uri, "range": stretch, "selectionRange": {"start": at, "end": at}}
    return {
        "textDocument": {"uri": uri},
        "uri": uri,
        "position": at,
        "positions": [at, VAST, PLACE],
        "range": stretch,
        "ranges": [stretch],
        "context": {"includeDeclaration": True, "diagnostics": [], "triggerKind": 1, "isRetrigger": False},
        "newName": "y",
        "query": "s",
        "previousResultId": "none",
        "previousResultIds": [{"uri": uri, "value": "none"}],
        "item": item,
        "label": "x",
        "command": "deburr.expand",
        "arguments": [{"uri": uri}],
        "options": {"tabSize": 4, "insertSpaces": True},
        "ch": "\n",
        "data": {"uri": uri},
        "title": "x",
    }


def is_error(found: Any) -> bool:
    return isinstance(found, dict) and set(found) <= {"code", "message", "data"} and "code" in found


@pytest.mark.parametrize("dialect", NAMES)
def test_every_request_at_every_sort_of_place(dialect: str) -> None:
    """In the program, behind its end, at no column that there is: an answer, or a refusal in words."""
    with Inside(RICH) as inside:
        inside.open("untitled:x", TEXTS[dialect], dialect)
        for method in ASKED:
            for at in (PLACE, VAST, {"line": 1, "character": 2**31 - 1}, {"line": 10**6, "character": 0}):
                found = inside.request(method, complete(method, "untitled:x", at))
                assert not is_error(found) or (found["code"] not in (-32603, -32602) and found["message"]), method


@pytest.mark.parametrize(
    "uri", ["untitled:letter", "file:///no/such.ngc", "nonsense", "http://[bad", "", "deburr-expanded:/x"]
)
def test_every_request_about_what_is_no_program(uri: str) -> None:
    with Inside(RICH) as inside:
        inside.open("untitled:letter", "Dear Sir,\n", "plaintext")
        for method in ASKED:
            found = inside.request(method, complete(method, uri, PLACE))
            assert not is_error(found) or found["code"] not in (-32603,), method


@pytest.mark.parametrize(
    "params",
    [
        None,
        {},
        [],
        7,
        {"textDocument": 7},
        {"textDocument": {"uri": 7}},
        {"textDocument": {"uri": "untitled:x"}, "position": {"line": "one", "character": None}},
        {"textDocument": {"uri": "untitled:x"}, "position": {"line": -1, "character": -7}, "range": {"start": PLACE}},
    ],
)
def test_every_request_with_parameters_that_are_not_as_they_must_be(params: Any) -> None:
    """A fault of the client is an error response, or nothing is made of it; it is none of ours, and the next request is answered."""
    with Inside(RICH) as inside:
        inside.open("untitled:x", TEXTS["rs274"], "rs274")
        for method in ASKED:
            found = inside.request(method, params)
            assert not found or not is_error(found) or found["code"] in (-32602, -32600), method
        hover = inside.request("textDocument/hover", {"textDocument": {"uri": "untitled:x"}, "position": PLACE})
        assert "#<deep>" in hover["contents"]["value"]


@pytest.mark.parametrize(
    ("method", "params"),
    [
        ("textDocument/didOpen", {}),
        ("textDocument/didOpen", {"textDocument": {"uri": "untitled:y", "text": 7}}),
        ("textDocument/didChange", {"textDocument": {"uri": "untitled:x"}}),
        ("textDocument/didChange", {"textDocument": {"uri": "untitled:x", "version": 2}, "contentChanges": [{"range": 7, "text": "a"}]}),
        ("textDocument/didChange", {"textDocument": {"uri": "untitled:x", "version": 2}, "contentChanges": [7]}),
        ("textDocument/didChange", {"textDocument": {"uri": "untitled:none", "version": 2}, "contentChanges": [{"text": "a"}]}),
        ("textDocument/didClose", {"textDocument": {"uri": "untitled:none"}}),
        ("textDocument/didSave", 7),
        ("workspace/didChangeConfiguration", {"settings": 7}),
        ("workspace/didChangeWatchedFiles", {"changes": [{"uri": 7}]}),
        ("workspace/didChangeWorkspaceFolders", {}),
        ("$/setTrace", {"value": "loud"}),
        ("$/cancelRequest", {"id": [1]}),
        ("window/workDoneProgress/cancel", {"token": "none"}),
    ],
)  # fmt: skip
def test_notifications_that_are_not_as_they_must_be_change_nothing(method: str, params: Any) -> None:
    with Inside(RICH) as inside:
        inside.open("untitled:x", TEXTS["rs274"], "rs274")
        inside.notify(method, params)
        assert inside.server.session.open["untitled:x"].document.text == TEXTS["rs274"]
        assert inside.request("textDocument/hover", {"textDocument": {"uri": "untitled:x"}, "position": PLACE})


def test_versions_out_of_order_are_taken_as_they_come(tmp_path: Path) -> None:
    """Changes build on each other in the order in which they are sent; their numbers only name what is answered."""
    with Inside() as inside:
        inside.open("untitled:x", "G21 G90\nM2\n", "rs274")
        for version, text in ((9, "(a (b)\n"), (3, ""), (3, "(c (d)\n")):
            change = edit(0, 0, 0, text) if text else edit(0, 0, 0, "", 1)
            inside.notify(
                "textDocument/didChange",
                {"textDocument": {"uri": "untitled:x", "version": version}, "contentChanges": [change]},
            )
        assert inside.server.session.open["untitled:x"].document.text == "(c (d)\nG21 G90\nM2\n"
        assert inside.pushed("untitled:x") == ["rs274.comment-nested"]
        last = [each for each in inside.said if each.get("method") == "textDocument/publishDiagnostics"][-1]
        assert last["params"]["version"] == 3


def test_a_document_that_is_opened_twice_is_the_last_one() -> None:
    with Inside() as inside:
        inside.open("untitled:x", "(a (b)\n", "rs274")
        inside.open("untitled:x", "G21 G90\nM2\n", "rs274")
        assert inside.pushed("untitled:x") == []


@pytest.mark.parametrize("method", ["workspace/diagnostic", "workspace/symbol", "textDocument/diagnostic"])
def test_a_request_that_is_cancelled_is_answered_as_cancelled(method: str, tmp_path: Path) -> None:
    for number in range(20):
        (tmp_path / f"{number}.ngc").write_text("G1 X1\n" * 500)
    folders = [{"uri": tmp_path.as_uri(), "name": "here"}]
    with Inside(RICH, workspaceFolders=folders) as inside:
        inside.open("untitled:x", TEXTS["rs274"] * 400, "rs274")
        number = inside.begin(method, complete(method, "untitled:x", PLACE))
        inside.notify("$/cancelRequest", {"id": number})
        answer = inside.wait(lambda each: each.get("id") == number and "method" not in each)
        assert answer["error"]["code"] == -32800
        assert inside.request("textDocument/hover", complete(method, "untitled:x", PLACE))


@pytest.mark.parametrize("dialect", NAMES)
def test_a_thousand_edits_through_a_real_server_leave_what_a_fresh_copy_is(
    dialect: str, launch: Callable[..., Client]
) -> None:
    """Edits as fast as they can be sent, diagnostics asked for now and then, in UTF-16 with characters of two units and both line ends."""
    client = launch()
    client.start({**PULLS, "general": {"positionEncodings": ["utf-16"]}})
    chance = random.Random(dialect)
    suffix = by_name(dialect).extensions[0]
    model = Model(TEXTS[dialect].replace("\n", "\r\n", 2) + "(😋) G1\n", "utf-16")
    uri = client.open(f"edited{suffix}", model.text, dialect)
    signs = ["😋", "\r\n", "\n", " ", "1", "#", "(", ")", "<", ">", "!", "|", "@", *model.text.split()]
    for _ in range(250):
        changes = []
        for _ in range(4):
            line, col = chance.randrange(12), chance.randrange(12)
            added = "" if chance.random() < 0.5 else chance.choice(signs)
            changes.append(model.change(Edit(Pos(line, col), Pos(line, col + chance.randrange(5)), added)))
        client.change(uri, *changes)
    fresh = client.open(f"fresh{suffix}", model.text, dialect)
    assert asked(client, uri) == asked(client, fresh)
    assert client.stop() == 0


def asked(client: Client, uri: str) -> list[Any]:
    """What hangs on every character of a document."""
    document = {"textDocument": {"uri": uri}}
    tokens = client.request("textDocument/semanticTokens/full", document)["data"]
    found = [tokens, client.request("textDocument/foldingRange", document), client.pulled(uri)]
    return json.loads(json.dumps(found).replace(uri, ""))  # type: ignore[no-any-return]
