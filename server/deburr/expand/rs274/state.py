"""What an RS274 program changes while it runs: parameters, calls, loops. Executes nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.fault import Fault, Frame, Halt

if TYPE_CHECKING:
    from deburr.expand.job import Job
    from deburr.expand.rs274.machine import Machine
    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.text import Span

LAST_PARAMETER = {"linuxcnc": 5601, "smithy": 5399}
ARGUMENTS = 30
"""#1 to #30 belong to a call (spec/rs274.md §6)."""
READ_ONLY = frozenset((*range(5400, 5414), *range(5420, 5429)))


class Loop(NamedTuple):
    """A loop that runs: its first line, the frame outside it, and how many passes a `repeat` has left."""

    first: int
    outer: Frame | None
    left: int = 0


class Activation:
    """A call: where it goes on, and what it hides of its caller."""

    __slots__ = ("again", "arguments", "frame", "locals", "loops", "restores", "row", "unit")

    def __init__(self, unit: Unit, row: int, state: State) -> None:
        self.unit = unit
        self.row = row
        self.arguments = state.params[1 : ARGUMENTS + 1]
        self.locals = state.locals
        self.loops = state.loops
        self.frame = state.frame
        self.restores = state.restores
        self.again: tuple[Unit, int, int] | None = None
        """Of a program that M98 called: where it starts, and how often it runs once more."""


class State:
    """All of it. ``row`` is the line that runs; closures of compiled lines read and write here."""

    def __init__(self, job: Job, machine: Machine) -> None:
        self.job = job
        self.machine = machine
        self.last = LAST_PARAMETER[job.settings["profile"]]
        self.params = [0.0] * (LAST_PARAMETER["linuxcnc"] + 1)
        self.globals: dict[str, float] = {}
        self.locals: dict[str, float] = {}
        self.loops: list[Loop] = []
        self.calls: list[Activation] = []
        self.frame: Frame | None = None
        self.value = 0.0
        self.value_returned = 0.0
        self.restores = False
        """Whether the running subprogram said M73, so that its end brings the modes back."""

    def fault(self, kind: str, file: str, row: int, span: Span, message: str) -> Halt:
        """The end of the run."""
        return Halt(Fault(kind, file, row, span, message, self.frame))

    def warn(self, kind: str, file: str, row: int, span: Span, message: str) -> None:
        """Something that the run passes."""
        self.job.meet(Fault(kind, file, row, span, message, self.frame))
