"""When the server looks for garbage: among all objects only where nobody types. Never decides what is kept.

A look at all that is known of a large program takes half a second. What a check leaves behind goes
without one, as soon as its analysis lets go; so what is known when a check is done is set aside, and
looked through again only where it has been quiet for a while.
"""

from __future__ import annotations

import gc
from time import monotonic
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop, TimerHandle

_YOUNG = (20_000, 10_000, 100)
"""New objects that are looked through at once, in a millisecond or some, and how seldom older ones are: a long check makes millions, and keeps them."""
_SLICES = 8
"""Slices of work, behind which what is new is looked through whatever was counted."""
_FEW = 10 * _YOUNG[0]
"""So many objects that were made since the last check can be looked through in some milliseconds."""
_QUIET = 10.0
"""Seconds without a message after which all is looked through."""
_SHARE = 60
"""It is quiet for so many times as long as the last look took."""


def begin() -> None:
    """Set aside what a process has loaded, and look for garbage as seldom as a server does."""
    gc.freeze()
    gc.set_threshold(*_YOUNG)
    gc.enable()


def set_aside(*, all_new: bool = True) -> None:
    """What is known now stays known for a while. ``all_new``: what was made since the last time is looked through, not the newest of it alone."""
    gc.collect(1 if all_new else 0)
    gc.freeze()


class Garbage:
    """Sets aside what is known, and looks through it in quiet times."""

    def __init__(self, loop: AbstractEventLoop) -> None:
        self._loop = loop
        self._timer: TimerHandle | None = None
        self._last = monotonic()
        self._taken = 0.0
        self._slices = self._made = self._looks = 0
        """Slices of work; objects that are known to have been made since the last check, and the looks at which they were counted."""
        begin()
        self._before = gc.get_count()[1]

    def heard(self) -> None:
        """A message has come."""
        self._last = monotonic()

    def worked(self) -> None:
        """A slice of work was done. Where as much is let go as is made, new objects are not counted, and there would be a million to look through at once."""
        self._slices += 1
        if not self._slices % _SLICES:
            self._made += gc.get_count()[0]
            self._looks += 1
            gc.collect(0)

    def checked(self) -> None:
        """A program was gone through: what is known now stays known for a while."""
        newest, looks, _ = gc.get_count()
        # Python's own looks come with as many objects each; what it looks at less often it never comes to between two checks.
        made = self._made + newest + max(looks - self._before - self._looks, 0) * _YOUNG[0]
        set_aside(all_new=made <= _FEW)
        self._made = self._looks = 0
        self._before = gc.get_count()[1]
        if self._timer is None:
            self._timer = self._loop.call_later(self._pause, self._look)

    @property
    def _pause(self) -> float:
        return max(_QUIET, self._taken * _SHARE)

    def _look(self) -> None:
        self._timer = None
        begun = monotonic()
        if begun - self._last < self._pause:
            self._timer = self._loop.call_later(self._last + self._pause - begun, self._look)
            return
        gc.unfreeze()
        gc.collect()
        gc.freeze()
        self._taken = monotonic() - begun
