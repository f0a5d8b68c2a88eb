"""Z32: runs of random programs beside what is proven of them (spec/z32.md §4 to §6)."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, lru_cache
from inspect import unwrap
from random import Random

import pytest

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.z32.fields import Fields, Step
from deburr.expand.z32.run import Run
from deburr.expand.z32.state import State
from deburr.expand.z32.unit import Op, Unit
from deburr.finding import Finding
from deburr.ruleset import RuleSet
from deburr.values import proofs as proven
from deburr.values import proving, values_of
from deburr.values.domain import Value, joined
from deburr.values.graph import Key
from deburr.values.z32 import conditions
from deburr.values.z32.expressions import ALIAS, named
from deburr.values.z32.made import fields_of, made
from deburr_grammar.document import Document
from deburr_grammar.tree import Node
from support.pages import MemoryHost
from support.runs import Language, Tried, Wrong
from support.runs import given as runs_of
from support.shrinking import Case, is_run
from support.z32 import DIALECT, MAIN
from support.z32programs import SETTINGS, generated, given

Place = tuple[str, int, int]
"""A file, a row, and which field of the line."""
_RUNS = 2
_DELETE = "block-delete"
_OPERATOR = "operator"
"""The file of a case that says for all its runs whether marked lines are left out."""


def _case(seed: int) -> Case:
    program, rng = generated(seed), Random(seed)
    delete = rng.choice((None, False, True))
    case = {MAIN: program.text, **program.files}
    if delete is not None:
        case[_OPERATOR] = json.dumps({_DELETE: delete})
    for at in range(1, _RUNS + 1):
        values: dict[str, object] = dict(given(rng))
        chosen = rng.choice((False, True)) if delete is None else delete
        case[f"run {at}"] = json.dumps({**values, _DELETE: chosen}) + "\n"
    return case


def tried(case: Case) -> Tried:
    """Run a program with each of the inputs that it is given beside its values."""
    analysis = _analysed(case)
    if values_of(analysis) is None:
        return Tried()
    findings = [each for each in proving(analysis) if each is not None]
    watch = _Watch(_Known(analysis), findings)
    endless = {finding.place.line for finding in findings if finding.rule == "z32.limit"}
    with watch.watching():
        for define in map(json.loads, runs_of(case)):
            watch.passed.clear()
            watch.jumped.clear()
            inputs = Inputs(block_delete=define.pop(_DELETE), define=define)
            programs = (Program(MAIN, analysis.document),)
            job = Job(programs, analysis.ruleset, analysis.host, watch, inputs, Budget(400, 0))
            for _ in drive(job):
                pass
            looping = [row for row in endless if (MAIN, row) in watch.passed]
            watch.confirmed["z32.limit"] += len(looping)
            if not job.cut and all(fault.kind == "range-open-at-end" for fault in job.faults):
                watch.wrong += [Wrong(row, "is a loop that ends", "", "it never ends") for row in looping]
                watch.wrong += [Wrong(place, "comes back", "", "it never does") for place in watch.open(job)]
    return Tried(watch.seen, watch.confirmed, watch.wrong)


def _analysed(case: Case) -> Analysis:
    """A program as it is checked."""
    files = {name: text for name, text in case.items() if not is_run(name) and name not in (MAIN, _OPERATOR)}
    folder = "cmos" if any(name.startswith("cmos/") for name in files) else ""
    delete = json.loads(case[_OPERATOR])[_DELETE] if _OPERATOR in case else None
    document = Document.parse(case.get(MAIN, ""), DIALECT)
    return Analysis(document, _ruleset(folder), MAIN, MemoryHost(files), inputs=Inputs(block_delete=delete))


@cache
def _ruleset(folder: str) -> RuleSet:
    return RuleSet(DIALECT, {**SETTINGS, "cmos-dir": folder})


class _Known:
    """What is proven of a program: the values before each field, and the fields that cannot be passed."""

    def __init__(self, analysis: Analysis) -> None:
        program = values_of(analysis)
        assert program is not None
        self.before: dict[Place, dict[Key, Value]] = {}
        stopping: dict[Place, bool] = {}
        for name, solved in program.solved.items():
            routine = program.routines[name]

            def place(number: int, files=routine.files, rows=routine.rows, nodes=routine.graph.nodes) -> Place:  # type: ignore[no-untyped-def]
                node = nodes[number]
                return files[node.line] if files is not None else MAIN, rows[node.line], node.part

            for number, env in solved.solution.before.items():
                at, old = place(number), self.before.get(place(number))
                self.before[at] = (
                    env if old is None else {key: joined(old[key], env[key]) for key in old.keys() & env.keys()}
                )
                stopping[at] = stopping.get(at, True) and number in solved.solution.proofs
        self.stopping = {at for at, stops in stopping.items() if stops}
        self.taking = {
            (file or MAIN, row)
            for routine in program.routines.values()
            for file, row in zip(routine.files or [""] * len(routine.rows), routine.rows)
        }


class _Watch:
    """Looks at the parameters before each field and block that is executed."""

    def __init__(self, known: _Known, findings: list[Finding]) -> None:
        self._known = known
        self._findings = {(each.place.file, each.place.line, each.place.col): each for each in findings}
        self.wrong: list[Wrong] = []
        self.seen = 0
        self.confirmed: Counter[str] = Counter()
        self.passed: set[tuple[str, int]] = set()
        self.jumped: set[tuple[str, int]] = set()
        """The lines of jumps with a return that were made."""

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    def keep(self, count: int) -> None:
        """Nor is one taken back."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each of them looked at."""
        compiled, step = Run._compiled, Fields.step

        def compiling(run: Run, unit: Unit, row: int) -> Op:
            op, kinds = compiled(run, unit, row), unit.document.node(row).kinds
            self.passed.add((unit.file, row))
            if (unit.file, row) not in self._known.taking or "advanced" in kinds:
                return op
            executed: Op = self._around((unit.file, row, 0), run._state, op)  # type: ignore[assignment]  # a block leads to a row
            if unit.code[row] is not None:
                unit.code[row] = executed
            return executed

        def stepping(fields: Fields, field) -> Step:  # type: ignore[no-untyped-def]
            node = fields._state.program.unit.document.node(fields._row)
            parts = [each.start for group in fields_of(node.tree) for each in group]
            place = (fields._values._file, fields._row, parts.index(field.start))
            op = self._judged(place, field, step(fields, field))
            return self._around(place, fields._state, op) if place[:2] in self._known.taking else op

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Run, "_compiled", compiling)
            patch.setattr(Fields, "step", stepping)
            yield

    def _judged(self, place: Place, field: Node, op: Step) -> Step:
        """A field that may be a condition which decides nothing, or a jump with a return."""
        found = self._findings.get((*place[:2], field.children[1].start)) if field.kind == "if" else None

        def executed() -> int | None:
            behind = op()
            if found is not None:
                self.confirmed[found.rule] += 1
            if found is not None and (behind is None) != ("always" in found.message):
                self.wrong.append(Wrong(place, "holds where it never does, or not", behind is None, found.message))
            if field.kind == "jump" and field.node("range_end") is not None:
                self.jumped.add(place[:2])
            return behind

        return executed

    def open(self, job: Job) -> list[object]:
        """The jumps that are proven never to return, but of which a run that has come to its end says nothing."""
        met = {(fault.kind, fault.file, fault.line) for fault in job.faults}
        never = [each.place[:2] for each in self._findings.values() if each.rule == "z32.range-open-at-end"]
        return [place for place in never if place in self.jumped and ("range-open-at-end", *place) not in met]

    def _around(self, place: Place, state: State, op: Callable[[], int | None]) -> Callable[[], int | None]:
        def executed() -> int | None:
            self._look(place, state)
            behind = op()
            if place in self._known.stopping:
                self.wrong.append(Wrong(place, "is passed"))
            return behind

        return executed

    def _look(self, place: Place, state: State) -> None:
        env = self._known.before.get(place)
        if env is None:
            self.wrong.append(Wrong(place, "is reached"))
        for key, value in (env or {}).items():
            if isinstance(key, str):
                self.seen += 1
                got = _held(state, key)
                if got is None or not value.has(got):
                    self.wrong.append(Wrong((place, key), "holds another value", got, value))


def _held(state: State, key: str) -> float | None:
    if key == ALIAS:
        return named(state.alias).low if state.alias else None
    if "[" in key:
        return (state.pal if key[2] == "L" else state.par)[int(key[4:-1])]
    return state.params.get(key)


def _false_that_goes_on_as_true(patch: pytest.MonkeyPatch) -> None:
    patch.setitem(conditions._OPPOSITE, "<", "<")
    # Lines keep what came of them.
    patch.setattr("deburr.values.z32.flow.made", lru_cache(unwrap(made)))


def _loops_that_all_never_end(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(proven, "_is_endless", lambda solution, loop: {loop.head, loop.test} <= solution.before.keys())


def _ways_that_are_all_dead(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(proven, "_is_dead", lambda solution, node, dead: not dead.later)


Z32 = Language(
    "z32",
    _case,
    tried,
    ("deburr.values.z32.split._graphs",),
    {
        "a false IF that goes on as if it were true": _false_that_goes_on_as_true,
        "loops of which all never end": _loops_that_all_never_end,
        "ways of which none is ever taken": _ways_that_are_all_dead,
    },
)
