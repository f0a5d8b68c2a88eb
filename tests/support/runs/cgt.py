"""CGT: runs of random templates and toolpaths beside what is proven of them (spec/cgt.md §5)."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from random import Random
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.arithmetic.cgt import operation
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.cgt import code, commands, pieces
from deburr.expand.cgt.state import State
from deburr.expand.cgt.words import Cell
from deburr.fault import Halt
from deburr.finding import Finding
from deburr.ruleset import RuleSet
from deburr.templates.items import Item
from deburr.values import operations, proofs, proving, values_of
from deburr.values.cgt import brackets, lifted
from deburr.values.cgt.words import Shown
from deburr.values.domain import NO, Value
from deburr.values.program import Program as Values
from deburr_grammar.document import Document
from support.cgt import DIALECT
from support.pages import MemoryHost
from support.runs import Language, Tried, Wrong, given
from support.shrinking import Case
from support.templates import events, template

MAIN = "main.cgt"
RULES, LISTED = RuleSet(DIALECT), RuleSet(DIALECT, {"input": "part.jsonl"})
_RUNS = 2
_WAYS = ("cgt.condition-constant", "cgt.loop-idle", "cgt.bracket-idle")


def _case(seed: int) -> Case:
    rng = Random(seed)
    text = template(rng)
    listed = ["".join(json.dumps(each) + "\n" for each in events(rng)) for _ in range(_RUNS)]
    return {MAIN: text, **{f"run {at}": each for at, each in enumerate(listed, 1)}}


def tried(case: Case) -> Tried:
    """Run a template with each of the toolpaths that it is given beside what is proven of it."""
    document = Document.parse(case.get(MAIN, ""), DIALECT)
    analysis = Analysis(document, RULES, MAIN)
    found = values_of(analysis)
    if found is None:
        return Tried()
    watch = _Watch(found, [each for each in proving(analysis) if each is not None])
    with watch.watching():
        for lines in given(case):
            host = MemoryHost({"part.jsonl": lines})
            job = Job((Program(MAIN, document),), LISTED, host, watch, Inputs(), Budget(1_000, 0))
            for _ in drive(job):
                pass
    return Tried(watch.seen, watch.confirmed, watch.wrong)


class _Watch:
    """Looks at the words before each command that is executed."""

    def __init__(self, found: Values, findings: list[Finding]) -> None:
        self._nodes: dict[tuple[int, int], tuple[str, int]] = {}
        for name, routine in found.routines.items():
            for number, node in routine.graph.nodes.items():
                if node.condition is not None:
                    self._nodes[routine.rows[node.line], node.condition.start] = (name, number)
        self._found = found
        self._findings = {tuple(each.place[1:3]): each for each in findings if each.rule in _WAYS}
        self.wrong: list[Wrong] = []
        self.seen = 0
        self.confirmed: Counter[str] = Counter()

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    def keep(self, count: int) -> None:
        """Nor is one taken back."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each command, test and count looked at."""
        commanded, tested, counted = commands.command, pieces.Pieces.test, code.Compiler._count

        def command(state: State, values: Any, item: Item) -> Any:
            put = commanded(state, values, item)
            return None if put is None else self._around(state, (item.line, item.start), put)

        def test(made: Any, body: Any) -> Any:
            at = body.head or body.opener
            span = at.span
            if body.head is not None:
                asked = body.head.node.node("tests") or body.head.node.node("string_tests")
                span = span if asked is None else asked
            return self._around(made._state, (at.line, span.start), tested(made, body), decides=True)

        def count(compiler: Any, head: Any) -> Any:
            start = head.node.children[2].start
            return self._around(compiler._state, (head.line, start), counted(compiler, head), decides=True)

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(pieces, "command", command)
            patch.setattr(pieces.Pieces, "test", test)
            patch.setattr(pieces.Pieces, "_lone_word", lambda *_: None)
            patch.setattr(code.Compiler, "_count", count)
            yield

    def _around(
        self, state: State, place: tuple[int, int], run: Callable[..., Any], decides: bool = False
    ) -> Callable[..., Any]:
        known = self._nodes.get(place)
        if known is None:
            return run
        name, number = known

        def watched(*arguments: Any) -> Any:
            solved = self._found.solved.get(name)
            env = solved.solution.before.get(number) if solved is not None else None
            if solved is None or env is None:
                self.wrong.append(Wrong(place, "is reached"))
                return run(*arguments)
            self._look(place, state, env)
            result = run(*arguments)
            if number in solved.solution.proofs:
                self.wrong.append(Wrong(place, "is passed", "", solved.solution.proofs[number].message))
            if (
                decides
                and bool(result) != (number + 1 in solved.solution.targets(number))
                and (result or set(solved.solution.targets(number)) == {number + 1})
            ):
                self.wrong.append(Wrong(place, "goes a way that is never taken", result))
            said = self._findings.get(place)
            if decides and said is not None:
                self.confirmed[said.rule] += 1
                if bool(result) != ("always holds" in said.message):
                    self.wrong.append(Wrong(place, "holds where it never does, or not", result, said.message))
            return result

        return watched

    def _look(self, place: tuple[int, int], state: State, env: dict[Any, Value]) -> None:
        for key, value in env.items():
            if isinstance(key, str):
                cell = state.words[key]
                self.seen += 1
                if not _holds(value, cell.value):
                    self.wrong.append(Wrong((place, key), "holds another value", cell.value, value))
            elif isinstance(key, Shown):
                self.seen += 1
                changed = _changed(state, state.words[key.name])
                if changed is not None and not value.has(float(not changed)):
                    self.wrong.append(Wrong((place, key), "has changed, or not", changed, value))


def _holds(value: Value, got: float | str | None) -> bool:
    return got in value.texts if isinstance(got, str) else got is not None and value.has(got)


def _changed(state: State, cell: Cell) -> bool | None:
    try:
        return state.changed(cell, None)  # type: ignore[arg-type]  # the place is only for faults
    except Halt:
        return None
    except AttributeError:
        return None


def _minus_that_adds(patch: pytest.MonkeyPatch) -> None:
    patch.setitem(lifted.OPERATORS, "-", operations.lifted(operation("-"), operations.plus))


def _marks_that_mean_their_opposite(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(brackets, "YES", NO)


def _ways_that_are_all_dead(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(proofs, "_is_dead", lambda solution, node, dead: not dead.later)


CGT = Language(
    "cgt",
    _case,
    tried,
    ("deburr.values.cgt.split._kept",),
    {
        "a subtraction that adds": _minus_that_adds,
        "marks of output that mean their opposite": _marks_that_mean_their_opposite,
        "ways of which none is ever taken": _ways_that_are_all_dead,
    },
)
