"""CGT: what runs of random templates see lies in what is proven of each command (spec/cgt.md §5)."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from random import Random
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.arithmetic.cgt import operation
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.cgt import code, pieces
from deburr.expand.cgt.state import State
from deburr.expand.cgt.words import Cell
from deburr.fault import Halt
from deburr.ruleset import RuleSet
from deburr.templates.items import Item
from deburr.values import operations, values_of
from deburr.values.cgt import lifted, split
from deburr.values.cgt.words import Shown
from deburr.values.domain import Value
from deburr.values.kept import Kept
from deburr.values.program import Program as Values
from deburr_grammar.document import Document
from support.cgt import DIALECT
from support.pages import MemoryHost
from support.templates import events, template

MAIN = "main.cgt"
RULES, LISTED = RuleSet(DIALECT), RuleSet(DIALECT, {"input": "part.jsonl"})


@pytest.mark.parametrize("first", range(0, 600, 60))
def test_runs_see_what_is_proven(first: int) -> None:
    """Each value that a run sees at a command lies in the range of its place, no command is passed of which a fault is proven, and no way is taken that is never taken."""
    seen = sum(_watched(seed) for seed in range(first, first + 60))
    assert seen > 1_000


def test_a_wrong_range_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof that runs are looked at: with a subtraction whose ranges are those of a sum, some differ."""
    monkeypatch.setattr(split, "_kept", Kept())
    monkeypatch.setitem(lifted.OPERATORS, "-", operations.lifted(operation("-"), operations.plus))
    with pytest.raises(AssertionError, match="seed"):
        for seed in range(50_000, 50_100):
            _watched(seed)


def test_a_way_that_is_wrongly_taken_for_dead_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """With marks of output that mean their opposite, brackets print that never should."""
    from deburr.values.cgt import brackets

    monkeypatch.setattr(split, "_kept", Kept())
    monkeypatch.setattr(brackets, "YES", brackets.NO)
    with pytest.raises(AssertionError, match="seed"):
        for seed in range(50_000, 50_100):
            _watched(seed)


def _watched(seed: int) -> int:
    rng = Random(seed)
    document = Document.parse(template(rng), DIALECT)
    found = values_of(Analysis(document, RULES, MAIN))
    assert found is not None, f"seed {seed}"
    watch, seen = _Watch(found), 0
    with watch.watching():
        for _ in range(2):
            lines = "\n".join(map(json.dumps, events(rng)))
            host = MemoryHost({"part.jsonl": lines})
            job = Job((Program(MAIN, document),), LISTED, host, watch, Inputs(), Budget(1_000, 0))
            for _ in drive(job):
                pass
            assert watch.wrong == [], f"seed {seed} with {lines}"
            seen += watch.seen
    return seen


class _Watch:
    """Looks at the words before each command that is executed."""

    def __init__(self, found: Values) -> None:
        self._nodes: dict[tuple[int, int], tuple[str, int]] = {}
        for name, routine in found.routines.items():
            for number, node in routine.graph.nodes.items():
                if node.condition is not None:
                    self._nodes[routine.rows[node.line], node.condition.start] = (name, number)
        self._found = found
        self.wrong: list[tuple[object, ...]] = []
        self.seen = 0

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each command, test and count looked at."""
        commanded, tested, counted = pieces.command, pieces.Pieces.test, code.Compiler._count

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
                self.wrong.append((place, "is reached"))
                return run(*arguments)
            self._look(place, state, env)
            result = run(*arguments)
            if number in solved.solution.proofs:
                self.wrong.append((place, "is passed", solved.solution.proofs[number].message))
            if (
                decides
                and bool(result) != (number + 1 in solved.solution.targets(number))
                and (result or set(solved.solution.targets(number)) == {number + 1})
            ):
                self.wrong.append((place, "goes a way that is never taken", result))
            return result

        return watched

    def _look(self, place: tuple[int, int], state: State, env: dict[Any, Value]) -> None:
        for key, value in env.items():
            if isinstance(key, str):
                cell = state.words[key]
                self.seen += 1
                if not _holds(value, cell.value):
                    self.wrong.append((place, key, value, cell.value))
            elif isinstance(key, Shown):
                self.seen += 1
                changed = _changed(state, state.words[key.name])
                if changed is not None and not value.has(float(not changed)):
                    self.wrong.append((place, key, value, changed))


def _holds(value: Value, got: float | str | None) -> bool:
    return got in value.texts if isinstance(got, str) else got is not None and value.has(got)


def _changed(state: State, cell: Cell) -> bool | None:
    try:
        return state.changed(cell, None)  # type: ignore[arg-type]  # the place is only for faults
    except Halt:
        return None
    except AttributeError:
        return None
