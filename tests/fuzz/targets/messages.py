"""Messages: whatever bytes a client sends, before it has said who it is or after, each request is answered once and the next message is taken."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator
from typing import Any

from deburr.lsp.start import answered
from deburr.lsp.stream import Frames, framed
from fuzz.choices import Choices, joined
from support.inside import Inside
from support.soak import about, requests

_MOST = 12


def run(data: bytes) -> None:
    """How a stream is cut into pieces, then bodies; each is framed or goes as it is."""
    choices = Choices(data)
    size, stream = choices.byte() + 1, b""
    while choices:
        framing = choices.byte()
        body = choices.part()
        stream += body if framing % 4 == 3 else framed(body)
    bodies = _cut(stream, size)
    assert bodies == _cut(stream, len(stream) + 1)
    for body in bodies:
        answered(body)
    with Inside() as inside:
        for body in bodies[:_MOST]:
            inside.loop.run_until_complete(_received(inside, body))
        inside.settle()
        _answered_once(inside, bodies[:_MOST])


async def _received(inside: Inside, body: bytes) -> None:
    inside.server.receive(body)


def _cut(stream: bytes, size: int) -> list[bytes]:
    frames = Frames()
    return [body for at in range(0, len(stream), size) for body in frames.feed(stream[at : at + size])]


def _answered_once(inside: Inside, bodies: list[bytes]) -> None:
    """No request has more than one answer, and each that has a plain number or name has one."""
    numbers = [_number(body) for body in bodies]
    asked, wanted = Counter(number for number, _ in numbers), Counter(number for number, whole in numbers if whole)
    given = Counter(repr(said["id"]) for said in inside.said if "method" not in said and said.get("id") is not None)
    for number, count in given.items():
        assert count <= asked[number], (number, inside.said)
    missing = [number for number, count in wanted.items() if given[number] < count == asked[number]]
    assert not missing, (missing, inside.said)


def _number(body: bytes) -> tuple[str, bool]:
    """The number that a message has, and whether it is one that must be answered."""
    try:
        message: Any = json.loads(body)
    except (ValueError, RecursionError):
        return "", False
    if not isinstance(message, dict) or message.get("id") is None:
        return "", False
    number, method = message["id"], message.get("method")
    return repr(number), type(number) in (int, str) and isinstance(method, str) and message.get("jsonrpc") == "2.0"


def seeds() -> Iterator[bytes]:
    """Every method right and slightly wrong, and what comes before any of them."""
    opened = {"uri": "untitled:a", "languageId": "rs274", "version": 1, "text": "G1 X1 (a (b)\nM2\n"}
    first = [
        _message("initialize", {"capabilities": {}, "processId": None, "rootUri": None}, 1),
        _message("textDocument/didOpen", {"textDocument": opened}),
    ]
    for at, method in enumerate(requests()):
        params = about("untitled:a", at % 2, at % 5)
        wrong = dict(list(params.items())[at % 3 :])
        said = [*first, _message(method, params, 2), _message(method, wrong, "x"), _message(method, None, 4)]
        yield joined((at * 7 % 256,), *(b"\0" + body for body in said))
    yield joined((9,), b"\x03Content-Length: 3\r\nX: y\r\n\r\n[1]Content-Length: 0\r\n\r\n", b"\x00[]", b'\x00{"id":1}')
    yield joined((3,), *(b"\0" + _message(method, {"id": 2}) for method in ("$/cancelRequest", "exit", "shutdown")))


def _message(method: str, params: Any, number: int | str | None = None) -> bytes:
    said = {"jsonrpc": "2.0", "method": method, "params": params}
    return json.dumps(said if number is None else {"id": number, **said}).encode()
