"""Work between messages, when the loop that drives it has ended."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

from deburr.lsp.client import client_of
from deburr.lsp.idle import Idle
from deburr.lsp.server import Server, _read
from deburr.lsp.stream import Frames, framed


def test_work_that_is_given_up_behind_the_end_asks_for_nothing_more() -> None:
    loop, failed, done = asyncio.new_event_loop(), list[Exception](), list[str]()
    idle = Idle(loop, failed.append)

    def work() -> Iterator[None]:
        try:
            yield
        finally:
            idle.later(0.0, iter(()))
            done.append("given up")

    begun = work()
    next(begun)
    loop.close()
    begun.close()
    assert (done, failed) == (["given up"], [])


def test_a_slice_ends_with_the_step_in_which_a_message_comes() -> None:
    loop, done, messages = asyncio.new_event_loop(), list[str](), list[str]()
    idle = Idle(loop, lambda error: None)
    idle.called = lambda: bool(messages)

    def answer() -> None:
        done.append(f"answered {messages.pop()}")

    def work() -> Iterator[None]:
        for step in range(4):
            if step == 1:
                messages.append("a message")
                loop.call_soon(answer)
            done.append(f"step {step}")
            yield
        loop.stop()

    idle.start("work", work())
    loop.run_forever()
    loop.close()
    assert done == ["step 0", "step 1", "answered a message", "step 2", "step 3"]


class Once:
    """A client of which the thread that reads gets one message."""

    def __init__(self, loop: asyncio.AbstractEventLoop, body: bytes) -> None:
        self.loop = loop
        self.data = [framed(body)]

    def receive(self) -> bytes:
        """The message, and then the end."""
        return self.data.pop() if self.data else b""

    def write(self, data: bytes) -> None:
        """Nobody reads."""

    def close(self) -> None:
        """Nothing is held."""


def test_a_message_that_has_come_calls_until_it_is_taken_up() -> None:
    loop = asyncio.new_event_loop()
    stream = Once(loop, b'{"jsonrpc": "2.0", "method": "$/setTrace", "params": {"value": "off"}}')
    server = Server(client_of({"capabilities": {}}), stream, loop)
    assert not server.idle.called()
    _read(stream, Frames(), server)
    assert server.idle.called()
    assert loop.run_until_complete(server.over) == 1, "nobody said that the client would go"
    assert not server.idle.called()
    loop.close()
