"""What a routine asks of the others while it is gone through, and what was found for it: kept by what it says, starts with and was told. Knows no language."""

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence
from typing import NamedTuple, Protocol

from deburr.values.graph import Env, Graph, Key, Summary, join
from deburr.values.kept import Kept
from deburr.values.solve import Solution

_VERSIONS = 8
"""So many answers are kept of one flow."""


class Asked(NamedTuple):
    """What a routine asked first of another one, and what it was told then; None of something that nobody can see."""

    label: str
    env: Env
    told: Summary | None


class Solved(NamedTuple):
    """A routine's values and those that it returns with, what it called and with what in all, and what it asked, in that order.

    ``returned``: None: it does not return. ``further``: of what was called that with which more was passed than when it was first asked.
    ``is_blind``: whether it calls something that nobody can see.
    """

    solution: Solution
    returned: Env | None
    called: Mapping[str, Env]
    further: Mapping[str, Env]
    asked: Sequence[Asked]
    is_blind: bool


class Answering(Protocol):
    """Who answers: all routines together."""

    is_general: bool

    def summary(self, label: str) -> Summary | None:
        """What is known of a routine; None: it is none of this program."""

    def answer(self, label: str, env: Env) -> Summary | None:
        """The same when it is first called, with these values."""


class _Version(NamedTuple):
    """What was found for a flow that starts with these values."""

    is_general: bool
    entry: Env
    solved: Solved


_kept: Kept[list[_Version]] = Kept()
"""What was found last for each flow."""
_latest: Kept[Solution] = Kept()
"""What was found last for each family of flows."""


def fit(nodes: int) -> None:
    """Make room for a program of so many nodes."""
    _kept.fit(nodes * _VERSIONS // 2)
    _latest.fit(nodes)


def gone_through(
    graph: Graph, entry: Env, program: Answering, forgotten: frozenset[Key]
) -> Generator[None, None, Solved]:
    """The values of a routine: those that are kept, if it is told what it was told then, which is asked in the same order."""
    versions = _kept.get(graph) or []
    alike = [
        each
        for each in versions
        if each.is_general == program.is_general and (each.entry is entry or each.entry == entry)
    ]
    asked: list[Asked] = []
    while alike:
        known = next((each for each in alike if len(each.solved.asked) == len(asked)), None)
        if known is not None:
            versions[:] = [known, *(each for each in versions if each is not known)][:_VERSIONS]
            return known.solved
        alike = _told_alike(alike, asked, program)
    ledger = _Ledger(program, asked)
    earlier = _latest.get(graph.family) if graph.family is not None else None
    solution = Solution(graph, entry, ledger, forgotten, earlier)
    yield from solution.steps()
    if graph.family is not None:
        _latest.add(graph.family, solution, len(graph.nodes))
    found = ledger.closed(solution)
    versions.insert(0, _Version(program.is_general, entry, found))
    del versions[_VERSIONS:]
    _kept.add(graph, versions, len(versions) * len(graph.nodes))
    return found


def _told_alike(versions: Sequence[_Version], asked: list[Asked], program: Answering) -> list[_Version]:
    """Those versions whose next question is answered as it was; it is asked, and added to those that were."""
    at = len(asked)
    known = program.summary(versions[0].solved.asked[at].label)
    possible = [each for each in versions if _is_like(each.solved.asked[at].told, known)]
    if not possible:
        return []
    label, env, _ = possible[0].solved.asked[at]
    asked.append(Asked(label, env, program.answer(label, env)))
    return [each for each in possible if each.solved.asked[at].told == asked[at].told]


def _is_like(one: Summary | None, two: Summary | None) -> bool:
    """Whether a routine is called with the same variables, so that the same is asked of it."""
    return one is two or (one is not None and two is not None and one[1:] == two[1:])


class _Ledger:
    """What one routine asks of the others."""

    def __init__(self, program: Answering, asked: list[Asked]) -> None:
        """``asked``: what has been asked in its name already, and was answered."""
        self._program = program
        self._told = {each.label: each.told for each in asked}
        self.called: dict[str, Env] = {}
        self.asked = asked

    def again(self) -> None:
        """Forget what calls were guessed to pass while the values of loops grew."""
        self.called.clear()

    def closed(self, solution: Solution) -> Solved:
        """All of it, when the routine was gone through."""
        first = {label: env for label, env, _ in self.asked}
        further = {label: env for label, env in self.called.items() if env != first[label]}
        is_blind = any(each.told is None for each in self.asked)
        return Solved(solution, solution.returned, self.called, further, self.asked, is_blind)

    def call(self, label: str, arguments: Env, shared: Env) -> Summary | None:
        """What is known of a routine; what it is called with is noted. While one is gone through, all its calls are told the same."""
        found = self._program.summary(label)
        env: Env = {}
        if found is not None:
            if not self._program.is_general:
                env = _passed(found, arguments, shared)
            known = self.called.get(label)
            self.called[label] = env if known is None or known == env else join(known, env)
        if label not in self._told:
            # What further calls pass is handed on when all are known: it is gone through once for all of them.
            self._told[label] = self._program.answer(label, env)
            self.asked.append(Asked(label, env, self._told[label]))
        return self._told[label]


def _passed(called: Summary, arguments: Env, shared: Env) -> Env:
    """Of what a call passes, what concerns the routine."""
    touched, mentions = called.touched, called.mentions
    env = {key: value for key, value in shared.items() if touched is None or key in touched}
    env.update((key, value) for key, value in arguments.items() if mentions is None or key in mentions)
    return env
