"""A server in this process: messages go in as bytes, and what it says is kept. Its loop runs only when it is asked to settle."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable
from time import monotonic
from typing import Any

from deburr.lsp.client import client_of
from deburr.lsp.server import Server
from deburr.lsp.stream import Frames

Json = dict[str, Any]

PATIENCE = 60.0
"""Seconds after which an answer is taken never to come."""


class Inside:
    """A server and what it has said. Anything that it logs as its own fault fails the test."""

    def __init__(self, capabilities: Json | None = None, **params: Any) -> None:
        self.loop = asyncio.new_event_loop()
        self.said: list[Json] = []
        self._frames = Frames()
        self._number = 0
        client = client_of({"capabilities": capabilities or {}, **params})
        self.server = Server(client, self, self.loop)

    def __enter__(self) -> Inside:
        return self

    def __exit__(self, *_: object) -> None:
        self.loop.close()

    def receive(self) -> bytes:
        """Nothing: messages come in by `send`."""
        return b""

    def write(self, data: bytes) -> None:
        """What the server says."""
        for body in self._frames.feed(data):
            message = json.loads(body)
            if message.get("method") == "window/logMessage":
                assert message["params"]["type"] != 1, message["params"]["message"]
            self.said.append(message)

    def close(self) -> None:
        """Nothing is held."""

    def notify(self, method: str, params: Any) -> None:
        """A notification; the server has dealt with it, but for what it does in its spare time."""
        self._send({"method": method, "params": params})

    def request(self, method: str, params: Any) -> Any:
        """A request and its result, or the error that it was refused with."""
        number = self.begin(method, params)
        until = monotonic() + PATIENCE
        while monotonic() < until:
            for message in self.said:
                if message.get("id") == number and "method" not in message:
                    self.said.remove(message)
                    return message["result"] if "result" in message else message["error"]
            self.loop.run_until_complete(self._turn())
        raise AssertionError(f"no answer to {method}")

    def begin(self, method: str, params: Any) -> int:
        """A request that is not waited for; its number."""
        self._number += 1
        self._send({"id": self._number, "method": method, "params": params})
        return self._number

    def wait(self, wanted: Callable[[Json], bool]) -> Json:
        """The first message of the server that is wanted; it is taken away."""
        until = monotonic() + PATIENCE
        while monotonic() < until:
            for message in self.said:
                if wanted(message):
                    self.said.remove(message)
                    return message
            self.loop.run_until_complete(asyncio.sleep(0.005))
        raise AssertionError(f"nothing of that sort was said; the last was {self.said[-1:]}")

    def open(self, uri: str, text: str, language: str) -> None:
        """Open a document."""
        item = {"uri": uri, "languageId": language, "version": 1, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def pushed(self, uri: str) -> list[str]:
        """The rules of the diagnostics that were pushed last for a document; the server has done all that it had to do."""
        self.settle()
        found = [each["params"] for each in self.said if each.get("method") == "textDocument/publishDiagnostics"]
        last = [each["diagnostics"] for each in found if each["uri"] == uri]
        return [each["code"] for each in last[-1]] if last else []

    def settle(self) -> None:
        """Let the server do all that it has to do."""
        self.loop.run_until_complete(self._idle())

    async def _idle(self) -> None:
        await asyncio.sleep(0)
        while self.server.idle.waits or self.server.checks.waits:
            await asyncio.sleep(0 if self.server.idle.waits else 0.01)
        await asyncio.sleep(0)

    def _send(self, message: Json) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.loop.run_until_complete(self._receive(body))

    async def _turn(self) -> None:
        """Let it do something, without waiting for what it does after a pause."""
        for _ in range(20):
            await asyncio.sleep(0)
        await asyncio.sleep(0.001)

    async def _receive(self, body: bytes) -> None:
        self.server.receive(body)
        await asyncio.sleep(0)
