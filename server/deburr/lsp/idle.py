"""Work between messages: generators that are driven in slices, the most urgent first. Never runs two slices without a look at the messages."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from time import monotonic
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

SLICE = 0.002
"""Seconds that a message may have to wait for work of ours."""

Work = Iterator[None] | Generator[None, None, Any]
T = TypeVar("T")


def driven(work: Iterator[T]) -> T:
    """Drive work for a slice; what its last step said. StopIteration at its end.

    A look at the messages behind each short step would starve the thread that reads them: Python hands it the turn only
    when nobody else has given theirs away and taken it back for as long as it waits.
    """
    until = monotonic() + SLICE
    while True:
        said = next(work)
        if monotonic() >= until:
            return said


class Idle:
    """Pieces of work under keys; a key has one at most. ``failed`` is told what a piece of work raised."""

    def __init__(self, loop: AbstractEventLoop, failed: Callable[[Exception], None]) -> None:
        self._loop = loop
        self._failed = failed
        self._waiting: dict[object, Work] = {}
        self._urgent: object = None
        self._planned = False
        self._coming = 0
        self.worked: Callable[[], None] = lambda: None
        """Called behind each slice."""
        self.called: Callable[[], bool] = lambda: False
        """Whether there is a message: then a slice ends with the step that is being done."""

    def start(self, key: object, work: Work, *, urgent: bool = False) -> None:
        """Do this as soon as there is nothing else to do, instead of what stood under the key."""
        self.drop(key)
        self._waiting[key] = work
        if urgent:
            self._urgent = key
        self._plan()

    def later(self, seconds: float, work: Work) -> None:
        """Do this, too, when some seconds have passed; never where the loop has ended, as work that is given up then may ask for."""
        if self._loop.is_closed():
            return
        self._coming += 1
        self._loop.call_later(seconds, self._come, work)

    def _come(self, work: Work) -> None:
        self._coming -= 1
        self.start(object(), work)

    def drop(self, key: object) -> None:
        """Leave a piece of work where it is. What it holds is let go when what is being done now is done."""
        work = self._waiting.pop(key, None)
        if isinstance(work, Generator) and not getattr(work, "gi_running", False):
            self._loop.call_soon(work.close)

    def has(self, key: object) -> bool:
        """Whether there is work under a key."""
        return key in self._waiting

    @property
    def waits(self) -> bool:
        """Whether there is any work."""
        return bool(self._waiting or self._coming)

    def _plan(self) -> None:
        if self._waiting and not self._planned:
            self._planned = True
            self._loop.call_soon(self._slice)

    def _slice(self) -> None:
        self._planned = False
        if not self._waiting:
            return
        key = self._urgent if self._urgent in self._waiting else next(iter(self._waiting))
        work = self._waiting[key]
        until = monotonic() + SLICE
        try:
            while not self.called() and monotonic() < until and self._waiting.get(key) is work:
                next(work)
        except StopIteration:
            self._done(key, work)
        except Exception as error:
            self._done(key, work)
            self._failed(error)
        self.worked()
        self._plan()

    def _done(self, key: object, work: Work) -> None:
        if self._waiting.get(key) is work:
            del self._waiting[key]
