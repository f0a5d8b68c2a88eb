"""The server inside another program's event loop, where there are no threads and no processes: bytes are handed in and out."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from deburr.lsp.start import answered
from deburr.lsp.stream import Frames


class Embedded:
    """A server for one client. ``write`` takes what is for the client; ``ended`` is told the exit code."""

    def __init__(self, write: Callable[[bytes], object], ended: Callable[[int], object]) -> None:
        self._frames = Frames()
        self._stream = _Out(write)
        self._ended = ended
        self._take = self._first

    def feed(self, data: bytes) -> None:
        """Take bytes that the client wrote."""
        for body in self._frames.feed(data):
            self._take(body)

    def _first(self, body: bytes) -> None:
        """A message before the client has introduced itself."""
        said = answered(body)
        if said.reply:
            self._stream.write(said.reply)
        if said.over:
            self._ended(1)
        if said.client is None:
            return
        from deburr.lsp.server import Server

        server = Server(said.client, self._stream, asyncio.get_event_loop())
        server.over.add_done_callback(lambda over: self._ended(over.result()))
        self._take = server.receive


class _Out:
    """A stream that is only written to; what comes in is handed to `Embedded.feed`."""

    def __init__(self, write: Callable[[bytes], object]) -> None:
        self._write = write

    def receive(self) -> bytes:
        """Nothing."""
        return b""

    def write(self, data: bytes) -> None:
        """All of the bytes."""
        self._write(data)

    def close(self) -> None:
        """There is nothing to close."""
