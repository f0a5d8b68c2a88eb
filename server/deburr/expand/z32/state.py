"""What a Z32 program changes while it runs: parameters, aliases, calls, ranges, loops. Executes nothing."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.fault import Entered, Fault, Frame, Halt
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.expand.job import Job
    from deburr.expand.z32.unit import Program, Unit

ELSEWHERE, END = -1, -2
"""What a line gives instead of the next row: the run goes on in another program, or is over."""
LAST = 512
"""The last index of PAL and PAR (spec/z32.md §5)."""
MACHINE = 256
"""From here on PAL belongs to the machine."""
DEEPEST = 32
"""Calls that may be under way at once; the main program is none (spec/z32.md §11)."""
WAITING = 10_000
"""Returns that may be pending at once: no program comes near, but for one that never stops."""


class Place(NamedTuple):
    """A part of a line of a file."""

    file: str
    row: int
    span: Span


class Loop:
    """A jump back that is repeated: from its first line to that of the jump. ``outer`` and ``frame``: what is around it."""

    __slots__ = ("first", "frame", "last", "outer")

    def __init__(self, first: int, last: int, outer: Loop | None, frame: Frame | None) -> None:
        self.first = first
        self.last = last
        self.outer = outer
        self.frame = frame


class Return(NamedTuple):
    """A pending return: the line at whose end it happens, the line that comes next, what that one is in, and the GON in words."""

    end: int
    behind: int
    loop: Loop | None
    frame: Frame | None
    place: Place
    said: str


class Pending:
    """The returns that are pending in one program, by the lines at whose end they happen."""

    __slots__ = ("_by_end", "_newest", "count")

    def __init__(self) -> None:
        self._by_end: dict[int, list[Return]] = {}
        self._newest = 0
        self.count = 0

    def push(self, found: Return) -> None:
        """One more."""
        self._by_end.setdefault(found.end, []).append(found)
        self._newest = found.end
        self.count += 1

    def take(self, end: int) -> Return | None:
        """The newest one of a line, which is then no longer pending."""
        found = self._by_end.get(end)
        if not found:
            return None
        self.count -= 1
        return found.pop()

    def redirect(self, to: Return) -> None:
        """Let the newest of all lead to where another one does."""
        found = self._by_end[self._newest]
        found[-1] = found[-1]._replace(behind=to.behind, loop=to.loop, frame=to.frame)

    def ways(self) -> tuple[int, dict[int, list[int]]]:
        """Where they lead, and which is the newest."""
        return self._newest, {end: [each.behind for each in found] for end, found in self._by_end.items() if found}

    def all(self) -> Iterator[Return]:
        """All of them."""
        for found in self._by_end.values():
            yield from found


class Activation(NamedTuple):
    """A call: the program that made it, the line where it goes on, and what that is in."""

    program: Program
    behind: int
    loop: Loop | None
    frame: Frame | None
    pending: Pending
    place: Place
    said: str


class State:
    """All of it. Closures of compiled lines read and write here."""

    def __init__(self, job: Job, main: Unit) -> None:
        self.job = job
        self.main = main
        self.unsure = False
        """Whether the run is where it is only if the operator's switch stands one way."""
        self.program = main.whole
        """The program that runs."""
        self.row = 0
        """Where it goes on after a call or a return."""
        self.axes = frozenset(str(job.settings["axes"]).upper())
        self.params: dict[str, float] = {}
        self.pal: list[float | None] = [None] * (LAST + 1)
        self.par: list[float | None] = [None] * (LAST + 1)
        self.alias = ""
        """The axes for which AA, AB and AC stand; empty before the first G25."""
        self.system = {"LX", "AE"}
        """Two-letter parameters of the system: they are output."""
        self.root = ""
        """The folder of L254 as the program names it."""
        self.uncertain: set[str] = set()
        """Parameters that an optional line may have set."""
        self.loop: Loop | None = None
        self.frame: Frame | None = None
        self.pending = Pending()
        self.calls: list[Activation] = []

    @cached_property
    def is_main(self) -> bool:
        """Whether it is certain that nothing calls the program that was started."""
        return self.main.is_main(self.job.settings)

    def fault(self, kind: str, place: Place, message: str, unsure: bool = False) -> Halt:
        """The end of the run."""
        return Halt(Fault(kind, *place, message, self.frame, unsure or self.unsure))

    def warn(self, kind: str, place: Place, message: str) -> None:
        """Something that the run passes."""
        self.job.meet(Fault(kind, *place, message, self.frame, self.unsure))

    def arrive(self, row: int) -> None:
        """Leave the loops in which a line of the running program does not stand."""
        loop = self.loop
        while loop is not None and not loop.first <= row <= loop.last:
            self.frame = loop.frame
            loop = self.loop = loop.outer

    def repeat(self, unit: Unit, first: int, last: int) -> None:
        """One more pass of the loop that starts at a line, or its first one."""
        loop = self.loop
        while loop is not None and loop.first != first:
            loop = loop.outer
        passes = 0
        if loop is None:
            loop = Loop(first, last, self.loop, self.frame)
        elif self.loop is not loop:
            passes = self._passes(loop)
        else:
            passes = self.frame.number if self.frame is not None else 0
        self.loop = loop
        self.frame = Frame(loop.frame, unit.file, first, Entered.LOOP, passes + 1)

    def _passes(self, loop: Loop) -> int:
        """How many passes a loop around the innermost one has made: the frame between the two says it."""
        inner = self.loop
        while inner is not None and inner.outer is not loop:
            inner = inner.outer
        return inner.frame.number if inner is not None and inner.frame is not None else 0
