"""How things are measured: in fresh processes, one after the other, nothing asserted. Never knows what it measures."""

from __future__ import annotations

import gc
import os
import re
import subprocess
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

T = TypeVar("T")
P = ParamSpec("P")
_STATUS = Path("/proc/self/status")
_HIGH_WATER = Path("/proc/self/clear_refs")


def isolated(function: Callable[P, T], *args: P.args, **named: P.kwargs) -> T:
    """The answer of a function in a process of its own, so that nothing is warm and its memory is its own."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(function, *args, **named).result()


def seconds(work: Callable[[], Any]) -> float:
    """How long a piece of work takes."""
    gc.collect()
    start = perf_counter()
    work()
    return perf_counter() - start


def processes(commands: Sequence[Sequence[str]], times: int) -> list[float]:
    """The median seconds that whole processes take, run in turns so that a busy machine slows all of them alike.

    A first round is not counted: it compiles the modules, as an installation does.
    """
    found: list[list[float]] = [[] for _ in commands]
    with TemporaryDirectory() as folder:
        environment = {key: said for key, said in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
        environment["PYTHONPYCACHEPREFIX"] = folder
        run = partial(subprocess.run, env=environment, capture_output=True, check=False)
        for _ in range(times + 1):
            for command, taken in zip(commands, found):
                taken.append(seconds(partial(run, command)))
    return [median(taken[1:]) for taken in found]


def growth(work: Callable[[], Any]) -> int:
    """By how many bytes resident memory rises above where it stands, at the most, while something is done.

    Read from the kernel's high-water mark, which is reset first: allocators that count each
    object would slow a large program down too much. 0 where there is no such mark (not Linux).
    """
    if not _HIGH_WATER.exists():
        work()
        return 0
    gc.collect()
    _HIGH_WATER.write_text("5")
    before = _resident("VmRSS")
    kept = work()
    del kept
    return _resident("VmHWM") - before


def _resident(field: str) -> int:
    match = re.search(rf"{field}:\s+(\d+) kB", _STATUS.read_text())
    return int(match[1]) * 1024 if match else 0
