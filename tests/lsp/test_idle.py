"""Work between messages, when the loop that drives it has ended."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator

from deburr.lsp.idle import Idle


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
