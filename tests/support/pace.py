"""How long the steps of a check are: a program is opened in a server, and each step of all that the server does in its spare time is measured.

`python -m support.pace DIALECT [LINES [PROGRAM]]`, in the folder of the tests, tells of the longest ones.
"""

from __future__ import annotations

import gc
import signal
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from time import process_time
from types import FrameType
from typing import Any, NamedTuple

from benchmarks.corpus import cam, macro, mixed
from benchmarks.macros import macros

from deburr.lsp import idle
from support.inside import Inside
from support.large import large

_EVERY = 0.002
"""Seconds of the processor between two looks at what is being done."""
_LONG = 0.01
"""Seconds of a step of which it is told where it was."""
_SHOWN = 6
"""Calls that are shown of a step, the innermost ones."""
_PROGRAMS = {"cam": cam, "macro": macro, "mixed": mixed}
_URI = "untitled:large"


class Step(NamedTuple):
    """A step: seconds of the processor, and the calls in which it was, outermost first."""

    seconds: float
    where: Sequence[str]


class Pace:
    """Measures the steps of pieces of work."""

    def __init__(self) -> None:
        self.steps: list[Step] = []
        self.total = 0.0
        self._seen: Counter[tuple[str, ...]] = Counter()
        self._begun = self._garbage = 0.0
        self._inside = False
        """Seconds of a step in which garbage was looked for."""
        signal.signal(signal.SIGPROF, self._look)
        gc.callbacks.append(self._collected)

    def measured(self, work: Iterator[Any]) -> Iterator[Any]:
        """The same work."""
        while True:
            self._seen.clear()
            self._garbage, self._inside = 0.0, True
            signal.setitimer(signal.ITIMER_PROF, _EVERY, _EVERY)
            begun = process_time()
            try:
                found = next(work)
            except StopIteration:
                return
            finally:
                taken = process_time() - begun
                signal.setitimer(signal.ITIMER_PROF, 0)
                self._inside = False
                self.total += taken
                if taken >= _LONG:
                    garbage = [f"garbage:{self._garbage * 1000:.0f}"] if 2 * self._garbage > taken else []
                    self.steps.append(Step(taken, [*self._where(), *garbage]))
            yield found

    def _collected(self, phase: str, info: dict[str, int]) -> None:
        if phase == "start":
            self._begun = process_time()
            return
        taken = process_time() - self._begun
        self._garbage += taken
        if not self._inside and taken >= _LONG:
            self.steps.append(Step(taken, ["garbage between two steps"]))

    def _look(self, number: int, frame: FrameType | None) -> None:
        stack = []
        while frame is not None and frame.f_code.co_filename != __file__:
            code = frame.f_code
            stack.append(f"{code.co_filename.partition('/deburr')[2]}:{code.co_name}")
            frame = frame.f_back
        self._seen[tuple(reversed(stack))] += 1

    def _where(self) -> Sequence[str]:
        """The calls in which most of a step was."""
        where: list[str] = []
        seen = self._seen
        while seen:
            inner = Counter[str]()
            for stack, times in seen.items():
                if len(stack) > len(where):
                    inner[stack[len(where)]] += times
            name, times = max(inner.items(), key=lambda each: each[1], default=("", 0))
            if 2 * times <= seen.total():
                break
            where.append(name)
            seen = Counter({stack: times for stack, times in seen.items() if stack[: len(where)] == tuple(where)})
        return where


def paced(dialect: str, text: str) -> Pace:
    """The steps in which a program is checked when it is opened."""
    pace, start = Pace(), idle.Idle.start

    def started(self: idle.Idle, key: object, work: idle.Work, *, urgent: bool = False) -> None:
        start(self, key, pace.measured(work), urgent=urgent)

    idle.Idle.start = started  # type: ignore[method-assign]
    try:
        with Inside({"textDocument": {"publishDiagnostics": {}}}) as server:
            server.open(_URI, text, dialect)
            server.settle()
    finally:
        idle.Idle.start = start  # type: ignore[method-assign]
    return pace


def program(dialect: str, lines: int, kind: str) -> str:
    """A program of so many lines."""
    if kind == "macros":
        return macros(dialect, lines)
    if kind == "large":
        return large(dialect, lines // 10)
    return _PROGRAMS[kind](lines)


def main(dialect: str, lines: str = "100000", kind: str = "macros") -> None:
    """Tell of the longest steps."""
    paced(dialect, program(dialect, 200, kind))
    text = program(dialect, int(lines), kind)
    pace = paced(dialect, text)
    print(f"{dialect} {kind}: {text.count(chr(10)):,} lines, {pace.total:.2f} s in all")
    places: dict[str, list[float]] = {}
    for step in pace.steps:
        places.setdefault(" ".join(step.where[-_SHOWN:]), []).append(step.seconds)
    for where, seconds in sorted(places.items(), key=lambda each: -max(each[1])):
        print(f"{max(seconds) * 1000:6.0f} ms {len(seconds):4}x  {where}")


if __name__ == "__main__":
    main(*sys.argv[1:])
