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
from unittest import mock

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
        self._begun = 0.0
        self._garbage = 0.0
        """Seconds of a step in which garbage was looked for."""
        self._inside = False
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


class Effort:
    """Counts the calls of each step, of functions of any sort: what a step does, whatever machine it is done on."""

    def __init__(self) -> None:
        self.most = 0
        self.where = ""
        """The step with the most: where the work was left before it, and where behind it."""
        self._calls = 0

    def measured(self, work: Iterator[Any]) -> Iterator[Any]:
        """The same work."""
        left = ""
        while True:
            self._calls = 0
            sys.setprofile(self._count)
            try:
                found = next(work)
            except StopIteration:
                return
            finally:
                sys.setprofile(None)
                before, left = left, " ".join(_left_at(work))
                if self._calls > self.most:
                    self.most, self.where = self._calls, f"{before}\n-> {left}"
            yield found

    def _count(self, frame: FrameType, event: str, argument: object) -> None:
        if event.endswith("call"):
            self._calls += 1


def _left_at(work: Any) -> Iterator[str]:
    """The lines at which generators wait for each other."""
    while (frame := getattr(work, "gi_frame", None)) is not None:
        code = frame.f_code
        yield f"{code.co_filename.rpartition('/')[2]}:{code.co_name}:{frame.f_lineno}"
        work = work.gi_yieldfrom


def drive(measure: Pace | Effort, dialect: str, text: str) -> None:
    """Measure the steps in which a server checks a program when it is opened."""
    start = idle.Idle.start

    def started(self: idle.Idle, key: object, work: idle.Work, *, urgent: bool = False) -> None:
        start(self, key, measure.measured(work), urgent=urgent)

    with (
        mock.patch.object(idle.Idle, "start", started),
        Inside({"textDocument": {"publishDiagnostics": {}}}) as server,
    ):
        server.open(_URI, text, dialect)
        server.settle()


def program(dialect: str, lines: int, kind: str) -> str:
    """A program of so many lines."""
    if kind == "macros":
        return macros(dialect, lines)
    if kind == "large":
        return large(dialect, lines // 10)
    return _PROGRAMS[kind](lines)


def main(dialect: str, lines: str = "100000", kind: str = "macros") -> None:
    """Tell of the longest steps."""
    pace = Pace()
    drive(pace, dialect, program(dialect, 200, kind))
    pace.steps.clear()
    pace.total = 0.0
    text = program(dialect, int(lines), kind)
    drive(pace, dialect, text)
    print(f"{dialect} {kind}: {text.count(chr(10)):,} lines, {pace.total:.2f} s in all")
    places: dict[str, list[float]] = {}
    for step in pace.steps:
        places.setdefault(" ".join(step.where[-_SHOWN:]), []).append(step.seconds)
    for where, seconds in sorted(places.items(), key=lambda each: -max(each[1])):
        print(f"{max(seconds) * 1000:6.0f} ms {len(seconds):4}x  {where}")


if __name__ == "__main__":
    main(*sys.argv[1:])
