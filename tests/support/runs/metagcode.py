"""MetaGCODE: runs of random templates beside what is proven of them (spec/metagcode.md §5)."""

from __future__ import annotations

import json
from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from decimal import Decimal
from functools import lru_cache
from inspect import unwrap
from random import Random

import pytest

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.metagcode.build import Run
from deburr.expand.metagcode.lines import Directive
from deburr.finding import Finding
from deburr.values import proofs, proving, values_of
from deburr.values.domain import Value, below
from deburr.values.metagcode import conditions, flow, orders
from deburr.values.metagcode.orders import Order
from deburr_grammar.dialects.metagcode.forms import number
from support.metagcode import NAMES, program
from support.runs import Language, Tried, Wrong, given
from support.shrinking import Case, is_run
from support.values import MAIN, Known, analysed, known

NUMBERS = ("0", "1", "2", "-1", "-3", "0.5", "5", "10", ".3", "-0.0", "7.25", "5.00", "1e3", "Steel", "Brass", "")
_RUNS = 3
_WAYS = ("condition-constant", "if-contradiction")


def _case(seed: int) -> Case:
    rng = Random(seed)
    text = program(rng)
    defined = [{each: rng.choice(NUMBERS) for each in NAMES} for _ in range(_RUNS)]
    return {MAIN: text, **{f"run {at}": json.dumps(each) + "\n" for at, each in enumerate(defined, 1)}}


def tried(case: Case) -> Tried:
    """Run a template with each of the values that it is given beside what is proven of it."""
    files = {name: text for name, text in case.items() if name != MAIN and not is_run(name)}
    analysis = analysed(case.get(MAIN, ""), "metagcode", files)
    found = known(analysis)
    if found is None:
        return Tried()
    watch = _Watch(found, _ways(analysis), [each for each in proving(analysis) if each is not None])
    with watch.watching():
        for define in map(json.loads, given(case)):
            programs = (Program(MAIN, analysis.document),)
            job = Job(programs, analysis.ruleset, analysis.host, watch, Inputs(define), Budget(2_000, 0))
            for _ in drive(job):
                pass
    return Tried(watch.seen, watch.confirmed, watch.wrong)


def _ways(analysis: Analysis) -> dict[int, set[bool]]:
    program = values_of(analysis)
    assert program is not None
    (routine,), (solved,) = program.routines.values(), program.solved.values()
    solution = solved.solution
    asking = [at for at, node in routine.graph.nodes.items() if at in solution.before and len(node.used) > 0]
    return {
        routine.rows[routine.graph.nodes[at].line]: {to == at + 1 for to in solution.targets(at)}
        for at in asking
        if solution.targets(at)
    }


class _Watch:
    """Looks at the variables before each directive that is followed."""

    def __init__(self, found: Known, ways: dict[int, set[bool]], findings: list[Finding]) -> None:
        """``ways``: of the directives, whether what stands in their blocks may come next, and what stands behind."""
        self._known = found
        self._ways = ways
        self._findings: dict[int, list[tuple[str, str]]] = defaultdict(list)
        for each in findings:
            if each.place.file == MAIN and each.rule.partition(".")[2] in _WAYS:
                self._findings[each.place.line].append((each.rule, each.message))
        self.wrong: list[Wrong] = []
        self.seen = 0
        self.confirmed: Counter[str] = Counter()

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    def keep(self, count: int) -> None:
        """Nor is one taken back."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each directive looked at."""
        followed = Run._directive

        def following(run: Run, at: int, step: Directive) -> int:
            if step.bracket.word.startswith("#END"):
                return followed(run, at, step)
            self._look(step.row, run._values)
            behind = followed(run, at, step)
            if (behind == at + 1) not in self._ways.get(step.row, (True, False)):
                self.wrong.append(Wrong(step.row, "goes a way that is never taken"))
            for rule, message in self._findings[step.row]:
                self.confirmed[rule] += 1
                if (behind == at + 1) != ("always holds" in message):
                    self.wrong.append(Wrong(step.row, "holds where it never does, or not", behind == at + 1, message))
            if step.row in self._known.stopping:
                self.wrong.append(Wrong(step.row, "is passed"))
            return behind

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Run, "_directive", following)
            yield

    def _look(self, row: int, values: dict[str, str]) -> None:
        env = self._known.before.get(row)
        if env is None:
            self.wrong.append(Wrong(row, "is reached"))
        for key, value in (env or {}).items():
            if isinstance(key, str):
                self.seen += 1
                got = number(values[key].strip(" \t"))
                if not (value.wild if got is None else _holds(value, got)):
                    self.wrong.append(Wrong((row, key), "holds another value", values[key], value))
            elif isinstance(key, Order):
                self.seen += 1
                if not value.has(_order(key, values)):
                    self.wrong.append(Wrong((row, key), "stands otherwise", _order(key, values), value))


def _order(key: Order, values: dict[str, str]) -> float:
    """Whether the first of two is less, the same or greater in a run: the reference compares numbers as decimals, and texts by code points."""
    one, two = values[key.name].strip(" \t"), key.other if key.is_text else values[key.other].strip(" \t")
    if not key.numeric:
        return float((one > two) - (one < two))
    left, right = number(one), number(two)
    assert left is not None and right is not None, "behind a comparison of numbers both are some"
    return float((left > right) - (left < right))


def _holds(value: Value, got: Decimal) -> bool:
    if value.empty or not value.low <= got <= value.high:
        return False
    return not (value.holed and got == 0) and (not value.step or value.has(float(got)))


def _with_new_nodes(patch: pytest.MonkeyPatch) -> None:
    """Nodes remember what they have answered: those of a fault are its own."""
    for name in ("_node", "_made"):
        patch.setattr(flow, name, lru_cache(unwrap(getattr(flow, name))))


def _less_that_is_more(patch: pytest.MonkeyPatch) -> None:
    _with_new_nodes(patch)
    patch.setitem(conditions._MIRRORED, "lessthan", "lessthan")
    patch.setattr(conditions, "above", below)


def _texts_behind_that_are_before(patch: pytest.MonkeyPatch) -> None:
    _with_new_nodes(patch)
    patch.setattr(orders, "_BEHIND", orders._BEFORE)


def _ways_that_are_all_dead(patch: pytest.MonkeyPatch) -> None:
    _with_new_nodes(patch)
    patch.setattr(proofs, "_is_dead", lambda solution, node, dead: not dead.later)


METAGCODE = Language(
    "metagcode",
    _case,
    tried,
    ("deburr.values.metagcode.flow._graphs",),
    {
        "less that is more": _less_that_is_more,
        "texts behind others that are before them": _texts_behind_that_are_before,
        "ways of which none is ever taken": _ways_that_are_all_dead,
    },
)
