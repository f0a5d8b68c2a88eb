"""A session from its first message to its last, and what must not end it."""

import json
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from deburr.lsp.stream import Frames, framed
from support.client import PULLS, Client, Refused, edit

FAULTY = "G21 G90 G17\nG1 X1 (a (b)\nF100\nM2\n"


def rules(found: list[dict[str, object]]) -> list[object]:
    return [each["code"] for each in found]


def test_start_edit_shut_down(client: Client) -> None:
    assert client.start()["serverInfo"]["name"] == "deburr"
    uri = client.open("a.ngc", FAULTY, "rs274")
    (found,) = client.pushed(uri)
    assert found["code"] == "rs274.comment-nested"
    assert found["source"] == "deburr"
    assert found["range"] == {"start": {"line": 1, "character": 9}, "end": {"line": 1, "character": 12}}
    client.change(uri, edit(1, 9, 12, ""))
    assert "rs274.comment-nested" not in rules(client.pushed(uri))
    client.close(uri)
    assert client.pushed(uri) == []
    assert client.stop() == 0


def test_a_client_that_asks_is_not_pushed_to(client: Client) -> None:
    assert client.start(PULLS)["capabilities"]["diagnosticProvider"]["interFileDependencies"] is True
    uri = client.open("a.ngc", FAULTY, "rs274")
    first = client.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})
    assert rules(first["items"]) == ["rs274.comment-nested"]
    assert first["items"][0]["codeDescription"]["href"] == "deburr-rule:/rs274.comment-nested.md"
    again = {"textDocument": {"uri": uri}, "previousResultId": first["resultId"]}
    assert client.request("textDocument/diagnostic", again) == {"kind": "unchanged", "resultId": first["resultId"]}
    assert [said["method"] for said in client.said] == ["window/logMessage"]


def test_the_workspace_is_asked_about_as_a_whole(client: Client) -> None:
    (client.folder / "part").mkdir()
    (client.folder / "part" / "bad.ngc").write_text(FAULTY)
    (client.folder / "good.ngc").write_text("G21 G90\nG0 X1\nM2\n")
    (client.folder / "readme.md").write_text("no program")
    client.start(PULLS)
    uri = client.open("open.ngc", FAULTY, "rs274")
    items = client.request("workspace/diagnostic", {"previousResultIds": []})["items"]
    found = {Path(each["uri"]).name: (rules(each["items"]), each["version"]) for each in items}
    assert found == {
        "open.ngc": (["rs274.comment-nested"], 1),
        "good.ngc": ([], None),
        "bad.ngc": (["rs274.comment-nested"], None),
    }
    known = [{"uri": each["uri"], "value": each["resultId"]} for each in items]
    (client.folder / "part" / "bad.ngc").write_text("G21 G90\nG0 X2\nM2\n")
    again = client.request("workspace/diagnostic", {"previousResultIds": known})["items"]
    assert {Path(each["uri"]).name: each["kind"] for each in again} == {
        "open.ngc": "unchanged",
        "good.ngc": "unchanged",
        "bad.ngc": "full",
    }
    assert uri


def test_nothing_is_answered_before_initialize(client: Client) -> None:
    with pytest.raises(Refused) as refused:
        client.request("textDocument/hover", {})
    assert refused.value.code == -32002
    client.notify("textDocument/didOpen", {})
    client.raw(framed(b"no json"))
    client.start()
    uri = client.open("a.ngc", FAULTY, "rs274")
    assert client.pushed(uri)


@pytest.mark.parametrize(
    ("message", "code"),
    [
        ({"jsonrpc": "2.0", "id": "x", "method": "textDocument/nonsense"}, -32601),
        ({"jsonrpc": "2.0", "id": "x", "method": "initialize", "params": {}}, -32600),
        ({"jsonrpc": "2.0", "id": "x", "method": "textDocument/diagnostic", "params": {"textDocument": 7}}, -32602),
        ({"jsonrpc": "2.0", "id": "x", "method": "textDocument/diagnostic"}, -32602),
        ({"jsonrpc": "1.0", "id": "x", "method": "shutdown"}, -32600),
    ],
)
def test_a_request_that_cannot_be_answered_is_refused(client: Client, message: dict[str, object], code: int) -> None:
    client.start(PULLS)
    client.send(message)
    with pytest.raises(Refused) as refused:
        client.result("x")
    assert refused.value.code == code
    assert client.stop() == 0


def test_what_is_no_message_ends_nothing(client: Client) -> None:
    client.start(PULLS)
    client.raw(framed(b"{"))
    client.raw(b"X-Nonsense: 1\r\n\r\n")
    client.send([1, 2])
    client.notify("$/nonsense", {"a": 1})
    client.notify("textDocument/didChange", {"textDocument": {"uri": "file:///no", "version": 1}, "contentChanges": []})
    client.notify("textDocument/didClose", {"textDocument": {"uri": "file:///never"}})
    client.notify("$/cancelRequest", {"id": 99})
    client.notify("$/setTrace", {"value": "verbose"})
    client.send({"jsonrpc": "2.0", "id": 4711, "result": None})
    uri = client.open("a.ngc", FAULTY, "rs274")
    assert rules(client.pulled(uri)) == ["rs274.comment-nested"]
    assert client.stop() == 0


def test_after_shutdown_only_exit_is_obeyed(client: Client) -> None:
    client.start()
    client.request("shutdown")
    with pytest.raises(Refused) as refused:
        client.request("textDocument/diagnostic", {"textDocument": {"uri": "file:///a"}})
    assert refused.value.code == -32600
    client.notify("exit")
    assert client.process.wait(20) == 0


def test_exit_without_shutdown_and_a_closed_pipe_are_no_success(launch: Callable[..., Client]) -> None:
    rude = launch()
    rude.start()
    rude.notify("exit")
    assert rude.process.wait(20) == 1
    gone = launch()
    gone.start()
    assert gone.process.stdin is not None
    gone.process.stdin.close()
    assert gone.process.wait(20) == 1


def test_it_does_not_outlive_the_process_that_started_it(client: Client) -> None:
    with subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"]) as parent:
        client.start(processId=parent.pid)
        uri = client.open("a.ngc", FAULTY, "rs274")
        assert client.pushed(uri)
        parent.kill()
    assert client.process.wait(20) == 1


def test_a_crash_costs_nothing_that_a_new_server_does_not_bring_back(launch: Callable[..., Client]) -> None:
    first = launch()
    first.start()
    uri = first.open("a.ngc", FAULTY, "rs274")
    found = first.pushed(uri)
    first.kill()
    second = launch()
    second.start()
    assert second.pushed(second.open("a.ngc", FAULTY, "rs274")) == found


def test_over_tcp(launch: Callable[..., Client], tmp_path: Path) -> None:
    command = [sys.executable, "-m", "deburr", "server", "--tcp", "127.0.0.1:0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, cwd=tmp_path) as server:
        assert server.stderr is not None
        said = re.search(rb":([0-9]+)\n", server.stderr.readline())
        assert said is not None
        with socket.create_connection(("127.0.0.1", int(said[1]))) as connection:
            connection.sendall(
                framed(json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {}}).encode())
            )
            frames, bodies = Frames(), []
            while not bodies:
                bodies += frames.feed(connection.recv(1 << 16))
            assert json.loads(bodies[0])["result"]["capabilities"]["positionEncoding"] == "utf-16"
        assert server.wait(20) == 1


def test_the_first_answer_waits_for_no_large_import() -> None:
    large = ("asyncio", "attrs", "cattrs", "lark", "lsprotocol", "pygls", "pathspec")
    code = f"import sys, deburr.lsp.start, deburr.lsp.stream, deburr.cli.server; print([m for m in {large} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_the_first_hover_waits_for_nothing_that_only_toolpaths_and_runs_need() -> None:
    code = "import sys; from deburr.lsp.server import found_features; found_features(); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = done.stdout.split()
    assert "deburr.lsp.features.hover" in loaded
    assert not [each for each in loaded if each.startswith(("deburr.motion", "deburr.plot", "deburr.expand.rs274"))]


def test_what_came_in_one_write_is_answered_in_order(client: Client) -> None:
    uri = (client.folder / "a.ngc").as_uri()
    item = {"uri": uri, "languageId": "rs274", "version": 1, "text": FAULTY}
    messages = [
        {"id": 1, "method": "initialize", "params": {"processId": os.getpid(), "capabilities": PULLS}},
        {"method": "initialized", "params": {}},
        {"method": "textDocument/didOpen", "params": {"textDocument": item}},
        {"id": 2, "method": "textDocument/diagnostic", "params": {"textDocument": {"uri": uri}}},
    ]
    client.raw(b"".join(framed(json.dumps({"jsonrpc": "2.0", **each}).encode()) for each in messages))
    assert client.result(1)["capabilities"]
    assert rules(client.result(2)["items"]) == ["rs274.comment-nested"]


def test_a_pull_that_an_edit_overtakes_is_to_be_asked_again(client: Client) -> None:
    client.start(PULLS)
    lines = "".join(f"N{number} G1 X{number} F100 Y[{number}+{'1+' * (number % 50)}1]\n" for number in range(20_000))
    uri = client.open("long.ngc", f"G21 G90 G17\n{lines}M2\n", "rs274")
    number = client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
    client.settle()
    client.change(uri, edit(1, 0, 0, "Q"))
    with pytest.raises(Refused) as refused:
        client.result(number)
    assert refused.value.code == -32802
    assert refused.value.data == {"retriggerRequest": True}
    number = client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
    client.settle()
    client.notify("$/cancelRequest", {"id": number})
    with pytest.raises(Refused) as refused:
        client.result(number)
    assert refused.value.code == -32800
    assert len(client.pulled(uri)) == 1


def test_a_document_closed_while_it_is_gone_through(client: Client) -> None:
    client.start(PULLS)
    uri = client.open("a.ngc", "".join(f"G1 X[{'1+' * (n % 90)}1]\n" for n in range(9000)), "rs274")
    number = client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
    client.settle()
    client.close(uri)
    with pytest.raises(Refused):
        client.result(number)
    assert client.pulled(client.open("a.ngc", FAULTY, "rs274"))


def test_a_thousand_quick_edits_leave_the_last_state(client: Client) -> None:
    client.start()
    uri = client.open("a.ngc", FAULTY, "rs274")
    for _ in range(500):
        client.change(uri, edit(1, 0, 0, "G"))
        client.change(uri, edit(1, 0, 1, ""))
    version = client.change(uri, edit(1, 6, 12, ""), edit(1, 0, 0, "F100 "))
    said = client.wait(
        "textDocument/publishDiagnostics", lambda params: params["version"] == version and not params["diagnostics"]
    )
    assert said["diagnostics"] == []
    time.sleep(0.3)
    assert client.stop() == 0
    assert [each for each in client.said if each["method"] == "textDocument/publishDiagnostics"] == []


@pytest.mark.parametrize(
    "said", [bytes(range(200, 256)), b"hello\n", b"Content-Length: abc\r\n\r\n{}", b"Content-Length: 2\r\n\r\nno", b""]
)
def test_what_is_no_client_is_told_so(tmp_path: Path, said: bytes) -> None:
    command = [sys.executable, "-m", "deburr", "server"]
    ran = subprocess.run(command, input=said, capture_output=True, cwd=tmp_path, timeout=60)
    assert (ran.returncode, ran.stderr.decode()) == (
        1,
        "deburr: error: what came is no stream of the language server protocol;"
        " editors start this command, and speak with it\n",
    )


def test_a_client_that_leaves_at_once_is_no_fault(tmp_path: Path) -> None:
    command, said = [sys.executable, "-m", "deburr", "server"], b'{"method": "exit"}'
    ran = subprocess.run(
        command,
        input=b"Content-Length: %d\r\n\r\n%b" % (len(said), said),
        capture_output=True,
        cwd=tmp_path,
        timeout=60,
    )
    assert (ran.returncode, ran.stderr) == (1, b"")
