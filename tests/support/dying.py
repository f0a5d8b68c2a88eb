"""deburr killed while it writes: `python -m support.dying PLACE ARGUMENTS...` in a folder whose `start` is what there is at first.

Each run is a process of its own, forked from this one so that it starts at once, and works in a fresh copy under the name
`work`. One is killed as `kill -9` does at each step of each file that is written, some are killed at any time. What is
left of each run is put into a folder of its own, whose name is said; `PLACE` is where. `again` in place of it runs in what
each of these left, and is not killed.
"""

from __future__ import annotations

import os
import random
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import IO, Any

from deburr.cli import replacing as module
from deburr.cli.main import main

ANY_TIME = 6
START, WORK = Path("start"), Path("work")


class Steps:
    """The steps of writing, counted; the process dies at one of them."""

    def __init__(self, last: int) -> None:
        self._left = last

    def step(self) -> None:
        """One more."""
        self._left -= 1
        if self._left == 0:
            os.kill(os.getpid(), signal.SIGKILL)

    def put_in(self) -> None:
        """Make deburr's writing go by steps: a file is opened, has half of what is written, has all, has its name."""
        steps, opened, put = self, module.replacing._opened, module.replacing._put

        def stepwise(self: module.replacing) -> IO[bytes]:
            out: Any = Slow(opened(self), steps)
            steps.step()
            return out  # type: ignore[no-any-return]

        def put_stepwise(self: module.replacing) -> None:
            steps.step()
            put(self)
            steps.step()

        module.replacing._opened = stepwise  # type: ignore[method-assign]
        module.replacing._put = put_stepwise  # type: ignore[method-assign]


class Slow:
    """A file into which all is written in two halves."""

    def __init__(self, out: IO[bytes], steps: Steps) -> None:
        self._out = out
        self._steps = steps

    def write(self, data: bytes) -> int:
        """Both halves."""
        self._out.write(data[: len(data) // 2])
        self._out.flush()
        self._steps.step()
        self._out.write(data[len(data) // 2 :])
        return len(data)

    def writelines(self, pieces: Any) -> None:
        """One after the other."""
        for piece in pieces:
            self.write(piece)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._out, name)


def forked(work: Callable[[], object], delay: float | None = None) -> int:
    """Do something in a process of its own, killed after a delay; its exit code, or the signal that ended it below 0."""
    child = os.fork()
    if child == 0:
        work()
        os._exit(0)
    if delay is not None:
        time.sleep(delay)
        os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def run(arguments: list[str], last: int = 0) -> None:
    """deburr in the folder, dead at a step."""
    os.chdir(WORK)
    os.environ.pop("DEBURR_CACHE_DIR", None)
    if last:
        Steps(last).put_in()
    main(arguments)
    sys.stdout.flush()


def loaded(arguments: list[str]) -> None:
    """Do it here once, so that no process has to load anything."""
    here = Path.cwd()
    shutil.copytree(START, WORK)
    run(arguments)
    os.chdir(here)
    shutil.rmtree(WORK)


def killed(arguments: list[str]) -> Iterator[str]:
    """Each run that was killed, and the one that was not."""
    loaded(arguments)
    last, code = 0, -signal.SIGKILL
    while code == -signal.SIGKILL:
        last += 1
        shutil.copytree(START, WORK)
        code = forked(partial(run, arguments, last))
        yield f"step {last}" if code else "whole"
    assert code == 0, code
    shutil.copytree(START, WORK)
    started = time.monotonic()
    forked(partial(run, arguments))
    whole = time.monotonic() - started
    shutil.rmtree(WORK)
    rng = random.Random()
    for number in range(ANY_TIME):
        shutil.copytree(START, WORK)
        forked(partial(run, arguments), rng.random() * whole)
        yield f"time {number}"


def again(place: Path, arguments: list[str]) -> Iterator[str]:
    """In what each run left."""
    loaded(arguments)
    for left in sorted(place.iterdir()):
        left.rename(WORK)
        code = forked(partial(run, arguments))
        assert code == 0, code
        yield left.name


def report(place: Path, names: Iterator[str]) -> None:
    """Keep what each run has left, and say which."""
    for name in names:
        WORK.rename(place / name)
        sys.stderr.write(f"{name}\n")


if __name__ == "__main__":
    where, *said = sys.argv[1:]
    if said[0] == "again":
        report(Path(where), again(Path(where), said[1:]))
    else:
        report(Path(where), killed(said))
