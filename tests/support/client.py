"""A client that speaks JSON with a real server process and leaves nothing out: it sends what it is told, right or wrong."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from queue import Empty, Queue
from tempfile import TemporaryFile
from threading import Thread
from typing import Any

from deburr.lsp.stream import Frames, framed

PATIENCE = 60.0
"""Seconds after which an answer is taken never to come."""

Json = dict[str, Any]

PULLS: Json = {
    "general": {"positionEncodings": ["utf-32"]},
    "textDocument": {"diagnostic": {"relatedDocumentSupport": True}},
    "workspace": {"diagnostics": {"refreshSupport": True}, "textDocumentContent": {}},
}
PUSHED: Json = {"general": {"positionEncodings": ["utf-16"]}, "workspace": {"workspaceFolders": True}}


class Refused(Exception):
    """An error response."""

    def __init__(self, error: Json) -> None:
        super().__init__(error["message"])
        self.code: int = error["code"]
        self.data = error.get("data")


class Client:
    """A server process and what it has said."""

    def __init__(self, folder: Path, *arguments: str, module: str = "deburr", **more: str) -> None:
        """Start `python -m MODULE server ARGUMENTS` in a folder, in an environment with ``more`` in it."""
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **more}
        command = [sys.executable, "-m", module, "server", *arguments]
        pipe = subprocess.PIPE
        self.log = TemporaryFile()  # noqa: SIM115  it lives as long as the process.
        self.process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=self.log, cwd=folder, env=environment)
        self.folder = folder
        self.patience = PATIENCE
        self.said: list[Json] = []
        """Notifications and requests of the server that nobody has waited for."""
        self.answer: Callable[[Json], Any] = lambda request: (
            [None] if "items" in (request.get("params") or {}) else None
        )
        self.answered: list[Any] = []
        """The numbers of all requests that were answered, in that order."""
        self._arrived: Queue[Json | None] = Queue()
        self._answers: dict[Any, Json] = {}
        self._number = 0
        self._versions: dict[str, int] = {}
        self._reader = Thread(target=self._read, daemon=True)
        self._reader.start()

    def start(self, capabilities: Json | None = None, **params: Any) -> Json:
        """The usual beginning; the result of `initialize`."""
        folders = [{"uri": self.folder.as_uri(), "name": "here"}]
        said = {"processId": os.getpid(), "capabilities": capabilities or PUSHED, "workspaceFolders": folders, **params}
        result: Json = self.request("initialize", said)
        self.notify("initialized", {})
        return result

    def stop(self) -> int:
        """The usual end; the exit code."""
        self.request("shutdown")
        self.notify("exit")
        return self.process.wait(PATIENCE)

    def kill(self) -> None:
        """The end in any case."""
        self.process.kill()
        self.process.wait()
        self._reader.join()
        for stream in (self.process.stdin, self.process.stdout, self.log):
            assert stream is not None
            with suppress(BrokenPipeError):
                stream.close()

    def logged(self) -> str:
        """What the server wrote on standard error."""
        self.log.seek(0)
        return self.log.read().decode()

    def send(self, message: Any) -> None:
        """Any message."""
        self.raw(framed(json.dumps(message).encode()))

    def raw(self, data: bytes) -> None:
        """Any bytes."""
        assert self.process.stdin is not None
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def notify(self, method: str, params: Any = None) -> None:
        """A notification."""
        self.send({"jsonrpc": "2.0", "method": method, **({} if params is None else {"params": params})})

    def ask(self, method: str, params: Any = None) -> int:
        """A request; its number."""
        self._number += 1
        self.send(
            {"jsonrpc": "2.0", "id": self._number, "method": method, **({} if params is None else {"params": params})}
        )
        return self._number

    def request(self, method: str, params: Any = None) -> Any:
        """A request and its result."""
        return self.result(self.ask(method, params))

    def settle(self) -> None:
        """Wait until the server has begun with all that it was sent."""
        with suppress(Refused):
            self.request("deburr/nothing")

    def result(self, number: Any) -> Any:
        """The result of a request; Refused if it is an error."""
        until = time.monotonic() + self.patience
        while number not in self._answers:
            self._take(until)
        answer = self._answers.pop(number)
        if "error" in answer:
            raise Refused(answer["error"])
        return answer["result"]

    def wait(self, method: str, wanted: Callable[[Any], bool] = lambda params: True) -> Any:
        """The parameters of the next notification or request of that method that is wanted."""
        until = time.monotonic() + self.patience
        while True:
            for number, message in enumerate(self.said):
                if message["method"] == method and wanted(message.get("params")):
                    del self.said[: number + 1]
                    return message.get("params")
            self._take(until)

    def open(self, name: str, text: str, language: str = "", version: int = 1) -> str:
        """Open a document; its URI."""
        uri = name if ":" in name else (self.folder / name).as_uri()
        self._versions[uri] = version
        item = {"uri": uri, "languageId": language or Path(name).suffix[1:], "version": version, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})
        return uri

    def change(self, uri: str, *changes: Json) -> int:
        """Edit a document; its version."""
        self._versions[uri] += 1
        document = {"uri": uri, "version": self._versions[uri]}
        self.notify("textDocument/didChange", {"textDocument": document, "contentChanges": list(changes)})
        return self._versions[uri]

    def close(self, uri: str) -> None:
        """Close a document."""
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri}})

    def pushed(self, uri: str, wanted: Callable[[list[Json]], bool] = lambda found: True) -> list[Json]:
        """The next diagnostics of a document that are wanted."""
        said = self.wait(
            "textDocument/publishDiagnostics", lambda params: params["uri"] == uri and wanted(params["diagnostics"])
        )
        found: list[Json] = said["diagnostics"]
        return found

    def pulled(self, uri: str) -> list[Json]:
        """The diagnostics of a document."""
        found: list[Json] = self.request("textDocument/diagnostic", {"textDocument": {"uri": uri}})["items"]
        return found

    def _take(self, until: float) -> None:
        try:
            message = self._arrived.get(timeout=max(0.01, until - time.monotonic()))
        except Empty:
            raise TimeoutError(f"the server is silent; it said last {self.said[-2:]}\n{self.logged()}") from None
        if message is None:
            raise EOFError(f"the server has gone: {self.process.wait(PATIENCE)}\n{self.logged()}")
        if "method" not in message:
            self._answers[message["id"]] = message
            self.answered.append(message["id"])
            return
        self.said.append(message)
        if "id" in message:
            self.send({"jsonrpc": "2.0", "id": message["id"], "result": self.answer(message)})

    def _read(self) -> None:
        assert self.process.stdout is not None
        frames = Frames()
        while data := os.read(self.process.stdout.fileno(), 1 << 20):
            for body in frames.feed(data):
                self._arrived.put(json.loads(body))
        self._arrived.put(None)


def edit(line: int, start: int, end: int, text: str, end_line: int | None = None) -> Json:
    """A change of a stretch of text."""
    last = line if end_line is None else end_line
    return {
        "range": {"start": {"line": line, "character": start}, "end": {"line": last, "character": end}},
        "text": text,
    }
