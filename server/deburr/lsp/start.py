"""The first moments of a server: `initialize` is answered before anything large is imported. Never understands any other request."""

from __future__ import annotations

import gc
import json
import sys
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.lsp.capabilities import answer
from deburr.lsp.client import Client, client_of
from deburr.lsp.stream import Frames, framed

if TYPE_CHECKING:
    from deburr.lsp.stream import Stream

NOT_INITIALIZED = -32002
PARSE_ERROR = -32700
INVALID_REQUEST = -32600
_NO_CLIENT = "what came is no stream of the language server protocol; editors start this command, and speak with it"


class Met(NamedTuple):
    """The client after its `initialize` was answered, and the messages that came with that one."""

    client: Client
    waiting: tuple[bytes, ...]


def serve(stream: Stream) -> int:
    """Serve one client to its end; the exit code."""
    frames = Frames()
    met = met_on(stream, frames)
    if met is None:
        return 1
    # Nothing of what is imported now is garbage; to look for some among it costs as much as our own modules do.
    gc.disable()
    from deburr.lsp.server import run

    return run(stream, frames, met)


def met_on(stream: Stream, frames: Frames) -> Met | None:
    """Wait for `initialize` and answer it; None if the client goes first. If it said nothing that is a message, standard error says so."""
    understood = False
    while data := stream.receive():
        bodies = frames.feed(data)
        for body in bodies:
            said = answered(body)
            understood = understood or said.understood
            if said.reply and not _sent(stream, said.reply):
                return None
            if said.client is not None:
                return Met(said.client, tuple(bodies))
            if said.over:
                return None
    if not understood:
        sys.stderr.write(f"deburr: error: {_NO_CLIENT}\n")
        sys.stderr.flush()
    return None


def _sent(stream: Stream, reply: bytes) -> bool:
    try:
        stream.write(reply)
    except BrokenPipeError:
        return False
    return True


class Answer(NamedTuple):
    """What a message before the server's start leads to: a reply, the client that has come, the end, and whether it was one at all."""

    reply: bytes = b""
    client: Client | None = None
    over: bool = False
    understood: bool = True


def answered(body: bytes) -> Answer:
    """What to do with a message as long as no client has come."""
    message = parsed(body)
    if not isinstance(message, dict):
        return Answer(error_for(None, PARSE_ERROR, "a message must be a JSON object"), understood=False)
    if message.get("method") == "initialize" and "id" in message:
        client = client_of(message.get("params"))
        return Answer(_response(message["id"], {"result": answer(client)}), client)
    if "id" in message and "method" in message:
        return Answer(error_for(message["id"], NOT_INITIALIZED, "`initialize` must come first"))
    return Answer(over=message.get("method") == "exit")


def parsed(body: bytes) -> Any:
    """The JSON of a body; None if it is none."""
    try:
        return json.loads(body)
    except (ValueError, RecursionError):
        return None


def error_for(number: Any, code: int, message: str, data: Any = None) -> bytes:
    """An error response."""
    error = {"code": code, "message": message} | ({} if data is None else {"data": data})
    return _response(number, {"error": error})


def _response(number: Any, outcome: dict[str, Any]) -> bytes:
    return framed(json.dumps({"jsonrpc": "2.0", "id": number, **outcome}).encode())
