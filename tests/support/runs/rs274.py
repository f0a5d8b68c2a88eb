"""RS274: runs of random programs beside what is proven of them (spec/rs274.md §3, §4, §6)."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, lru_cache
from inspect import unwrap

import pytest

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.rs274.compiling import Compiler
from deburr.expand.rs274.state import State
from deburr.expand.rs274.unit import Block, Op, Unit
from deburr.finding import Finding
from deburr.values import operations, proofs, proving
from deburr.values.graph import Env
from deburr.values.rs274 import expressions, lines
from deburr_grammar.dialect import Role
from support import loops
from support.programs import generated
from support.runs import Language, Tried, Wrong
from support.shrinking import Case
from support.values import MAIN, Known, analysed, known, known_generally

_STEPS = 3_000
_WAYS = ("condition-constant", "loop-idle")


def _case(seed: int) -> Case:
    program = generated(seed)
    return {MAIN: program.text, **program.files}


def tried(case: Case) -> Tried:
    """Run a program beside its values."""
    analysis = analysed(case.get(MAIN, ""), "rs274", {name: text for name, text in case.items() if name != MAIN})
    if known(analysis) is None:
        return Tried()
    watch = _Watch(analysis)
    with watch.watching():
        programs = (Program(MAIN, analysis.document),)
        inputs, budget = Inputs(simulate=True), Budget(_STEPS, 0)
        job = Job(programs, analysis.ruleset, analysis.host, watch, inputs, budget)
        for _ in drive(job):
            pass
    watch.ended(job)
    return Tried(watch.seen, watch.confirmed, watch.wrong)


class _Watch:
    """Looks at the parameters before each line that is executed, at ways that are never taken, and at loops that never end."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._subs = {row for row, bracket in analysis.document.brackets() if bracket.role is Role.REGION}
        self._proven: dict[str, tuple[Known, Known]] = {}
        self._ways: dict[tuple[str, int], list[Finding]] = defaultdict(list)
        self._endless: set[tuple[str, int]] = set()
        self._looping: dict[int, Block] = {}
        for found in proving(analysis):
            if found is not None and found.rule.partition(".")[2] in _WAYS:
                self._ways[found.place[:2]].append(found)
            elif found is not None and found.rule == "rs274.limit":
                self._endless.add(found.place[:2])
        self.wrong: list[Wrong] = []
        self.seen = 0
        self.confirmed: Counter[str] = Counter()

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    def keep(self, count: int) -> None:
        """Nor is one taken back."""

    def ended(self, job: Job) -> None:
        """A run that came to a loop that never ends stopped in it, because it was enough or because nothing changed any more."""
        last = job.faults[-1] if job.faults else None
        for row, block in self._looping.items():
            self.confirmed["rs274.limit"] += 1
            if last is None or last.kind != "limit" or not block.open <= last.line <= block.close:
                self.wrong.append(Wrong(row, "is a loop that ends", last, "it never ends"))

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each line looked at."""
        compiled = Compiler.compiled

        def compiling(compiler: Compiler, unit: Unit, row: int) -> Op:
            op = compiled(compiler, unit, row)
            found, general = self._of(unit.file)
            # What only stops the run for a moment is no line, and is gone when it goes on.
            is_paused = op.__name__ == "_paused"
            if is_paused or row not in found.taking or (unit.file == MAIN and row in self._subs):
                return op

            def executed() -> int:
                for each in (found, general):
                    self._compare(row, compiler.state, each.before.get(row))
                if (unit.file, row) in self._endless:
                    self._looping[row] = unit.blocks[row]
                behind = op()
                if row in found.stopping:
                    self.wrong.append(Wrong(row, "is passed"))
                self._judge(unit, row, behind)
                return behind

            unit.code[row] = executed
            return executed

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Compiler, "compiled", compiling)
            yield

    def _judge(self, unit: Unit, row: int, behind: int) -> None:
        """Whether a line goes where nothing that is said of it, or of a condition that is asked behind it, ever goes."""
        block = unit.blocks.get(row)
        if block is None or (row in block.middles):
            return
        for asked in (row, *block.middles) if row == block.open else (row,):
            first = block.open + 1 if row == block.close else asked + 1
            for found in self._ways[unit.file, asked]:
                self.confirmed[found.rule] += 1
                always = "always holds" in found.message
                came = behind > first if always else behind == first
                if came:
                    self.wrong.append(Wrong(row, "goes a way that is never taken", behind, found.message))

    def _of(self, file: str) -> tuple[Known, Known]:
        """What is proven of a file, and what whatever it is called with."""
        if file not in self._proven:
            found, general = known(self._analysis, file), known_generally(self._analysis, file)
            assert found is not None and general is not None
            self._proven[file] = found, general
        return self._proven[file]

    def _compare(self, row: int, state: State, env: Env | None) -> None:
        if env is None:
            self.wrong.append(Wrong(row, "is reached"))
        for key, value in (env or {}).items():
            self.seen += 1
            names = state.globals if str(key).startswith("_") else state.locals
            got = state.params[key] if isinstance(key, int) else names.get(str(key))
            if not (value.unset if got is None else value.has(got)):
                self.wrong.append(Wrong((row, key), "holds another value", got, value))


def _minus_that_adds(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(operations, "minus", operations.plus)
    patch.setattr(expressions, "lifted_operation", cache(expressions.lifted_operation.__wrapped__))
    # Lines keep what they were compiled to.
    patch.setattr(lines, "_line", lru_cache(unwrap(lines._line)))


def _loops_that_all_never_end(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(proofs, "_is_endless", lambda solution, loop: {loop.head, loop.test} <= solution.before.keys())


def _ways_that_are_all_dead(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(proofs, "_is_dead", lambda solution, node, dead: not dead.later)


RS274 = Language(
    "rs274",
    _case,
    tried,
    ("deburr.values.rs274.split._graphs",),
    {
        "a subtraction that adds": _minus_that_adds,
        "loops of which all never end": _loops_that_all_never_end,
        "ways of which none is ever taken": _ways_that_are_all_dead,
    },
)
LOOPS = RS274._replace(case=lambda seed: {MAIN: loops.generated(seed)})
"""The same with loops that may never end."""
