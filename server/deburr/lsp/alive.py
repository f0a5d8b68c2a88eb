"""Whether the client's process still lives: a server whose client died must not stay behind."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

EVERY = 3.0
"""Seconds between two looks."""


def watch(process: int, loop: AbstractEventLoop, gone: Callable[[], None]) -> None:
    """Call ``gone`` when a process is no more."""

    def look() -> None:
        if lives(process):
            loop.call_later(EVERY, look)
        else:
            gone()

    loop.call_later(EVERY, look)


def lives(process: int) -> bool:
    """Whether there is a process of that number."""
    if sys.platform == "win32":
        return _lives_on_windows(process)
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        # It is there, and another user's; or no number of a process at all, so that nothing is known.
        return True
    return True


def _lives_on_windows(process: int) -> bool:
    """There, signal 0 would end the process."""
    import ctypes

    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined,unused-ignore]  # only there is `windll`
    handle = kernel.OpenProcess(0x00100000, False, process)
    if not handle:
        return False
    still = kernel.WaitForSingleObject(handle, 0) == 0x102
    kernel.CloseHandle(handle)
    return bool(still)
