"""How far a check is, on a terminal. Never writes where nobody looks."""

import sys
from collections.abc import Iterable, Iterator
from time import monotonic
from typing import TypeVar

T = TypeVar("T")
_PAUSE = 0.1
"""Seconds between two numbers: more of them nobody reads."""
_CLEAR = "\r\x1b[K"


def shown(work: Iterable[T], count: int) -> Iterator[T]:
    """The same work; how much of it is done stands on the last line of stderr, and is gone at the end."""
    said = monotonic()
    try:
        for done, each in enumerate(work, 1):
            if (now := monotonic()) - said > _PAUSE:
                said = now
                print(f"{_CLEAR}deburr: {done:,} of {count:,} programs", end="", file=sys.stderr, flush=True)
            yield each
    finally:
        print(_CLEAR, end="", file=sys.stderr, flush=True)
