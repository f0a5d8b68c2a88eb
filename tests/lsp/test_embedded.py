"""The server inside another program's event loop: bytes in, bytes out, without threads."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from deburr.lsp.embedded import Embedded
from deburr.lsp.stream import Frames, framed


def message(method: str, params: Any, number: int | None = None) -> bytes:
    said = {"jsonrpc": "2.0", "method": method, "params": params} | ({} if number is None else {"id": number})
    return framed(json.dumps(said).encode())


HELLO = message("initialize", {"processId": None, "rootUri": None, "capabilities": {}}, 1)


class Host:
    """What a program does that has a server inside."""

    def __init__(self) -> None:
        self.said: list[Any] = []
        self.codes: list[int] = []
        self.server = Embedded(self._written, self.codes.append)
        self._frames = Frames()

    def _written(self, data: bytes) -> None:
        self.said += [json.loads(body) for body in self._frames.feed(data)]

    async def until(self, number: int) -> Any:
        """The answer to a request."""
        async with asyncio.timeout(60):
            while not (found := [each for each in self.said if each.get("id") == number]):
                await asyncio.sleep(0.01)
        return found[0]


def test_it_serves_a_client_from_hello_to_exit() -> None:
    async def session() -> Host:
        host = Host()
        for cut in (HELLO[:30], HELLO[30:]):
            host.server.feed(cut)
        assert host.said[0]["result"]["serverInfo"]["name"] == "deburr"
        program = {"uri": "untitled:a", "languageId": "rs274", "version": 1, "text": "#1=3\nM2\n"}
        host.server.feed(message("initialized", {}) + message("textDocument/didOpen", {"textDocument": program}))
        host.server.feed(
            message("workspace/executeCommand", {"command": "deburr.expand", "arguments": [{"uri": "untitled:a"}]}, 2)
        )
        assert (await host.until(2))["result"]["text"] == "M2\n"
        host.server.feed(message("shutdown", None, 3))
        await host.until(3)
        host.server.feed(message("exit", None))
        await asyncio.sleep(0.05)
        return host

    assert asyncio.run(session()).codes == [0]


def test_before_hello_nothing_else_is_answered() -> None:
    host = Host()
    host.server.feed(message("textDocument/hover", {}, 7))
    host.server.feed(message("exit", None))
    assert host.said == [
        {"jsonrpc": "2.0", "id": 7, "error": {"code": -32002, "message": "`initialize` must come first"}}
    ]
    assert host.codes == [1]
