"""What an RS274 program changes while it runs: parameters, calls, loops. Executes nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.fault import Fault, Frame, Halt

if TYPE_CHECKING:
    from collections.abc import Callable

    from deburr.expand.job import Job
    from deburr.expand.rs274.machine import Machine
    from deburr.expand.rs274.modes import Modes
    from deburr.expand.rs274.unit import Unit
    from deburr_grammar.text import Span

LAST_PARAMETER = {"linuxcnc": 5601, "smithy": 5399}
ARGUMENTS = 30
"""#1 to #30 belong to a call (spec/rs274.md §6)."""
READ_ONLY = frozenset((*range(5400, 5414), *range(5420, 5429)))
ENDLESS = -1
"""The passes that a loop has left that counts none."""


class Loop(NamedTuple):
    """A loop that runs: its first line, the frame outside it, and how many passes a `repeat` has left."""

    first: int
    outer: Frame | None
    left: int = ENDLESS


class Saved:
    """Modes that were saved."""

    __slots__ = ("modes",)

    def __init__(self, modes: Modes) -> None:
        self.modes = modes


class Activation:
    """A call: where it goes on, and what it hides of its caller."""

    __slots__ = ("again", "arguments", "frame", "locals", "loops", "returns", "row", "saved", "then", "unit")

    def __init__(self, unit: Unit, row: int, state: State) -> None:
        self.unit = unit
        self.row = row
        self.arguments = state.params[1 : ARGUMENTS + 1]
        self.locals = state.locals
        self.loops = state.loops
        self.frame = state.frame
        self.saved = state.saved
        self.returns = state.returns
        self.again: tuple[Unit, int, int] | None = None
        """Of a program that M98 called: where it starts, and how often it runs once more."""
        self.then: Callable[[], None] | None = None
        """What is done when it returns."""


class State:
    """All of it; closures of compiled lines read and write here."""

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
        self.saved: Saved | None = None
        """What M70 or M73 saved at this level of calls."""
        self.returns = False
        """Whether the end of this call brings back what is saved: `M73` says so, and neither `M70` nor `M71` takes it back."""
        self.slot: Saved | None = None
        """What the flat program has saved: it has one place for all levels."""
        self.leaks = Leaks()
        self.contour: list[tuple[str, Unit, int, Frame | None]] | None = None
        """The lines of the contour that is being read for a lathe cycle."""

    def values(self) -> tuple[object, ...]:
        """All that decides how the run goes on from this line, to be compared."""
        leaks = (self.leaks.broke, self.leaks.continued, dict(self.leaks.counters))
        own = (self.params.copy(), dict(self.globals), dict(self.locals), self.value, self.value_returned)
        return (*own, len(self.calls), *leaks, self.machine.values())

    def fault(self, kind: str, file: str, row: int, span: Span, message: str) -> Halt:
        """The end of the run."""
        return Halt(Fault(kind, file, row, span, message, self.frame))

    def warn(self, kind: str, file: str, row: int, span: Span, message: str) -> None:
        """Something that the run passes."""
        self.job.meet(Fault(kind, file, row, span, message, self.frame))


class Leaks:
    """What the installed interpreter keeps of one loop for the next by mistake (spec/oracle.md §4). It only decides where to warn."""

    def __init__(self) -> None:
        self.broke = False
        """It has met a `break` and not yet come to the end of a `do` loop, which it would end."""
        self.continued = False
        """It has met the `continue` of a `do` loop, and goes back at the next end of a loop to which it skips."""
        self.counters: dict[tuple[str, int], int] = {}
        """Passes that are left of each `repeat` that was not run to its end, by file and row."""
