"""A program's routines together: what they are called with and what they leave behind, until nothing changes. What was found is kept by content.

Knows no language: a dialect gives the routines, their flow, and what each starts with.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Generator, Iterator, Mapping, Sequence
from functools import cached_property, reduce
from typing import NamedTuple

from deburr.values.again import again
from deburr.values.domain import Value, joined
from deburr.values.graph import Env, Graph, Key, Summary, join, unset, widen
from deburr.values.ledger import Solved, fit, gone_through
from deburr.values.reach import callers_first, unknown
from deburr.values.solve import Solution

_PATIENCE = 2
"""So often what a routine is called with, or leaves, may grow as it likes."""
_BACK = 3
"""Rounds in which what routines are called with gets less. The values of each round are true, so that any number will do."""
_DEEPEST = 20
"""Through so many routines in each other one goes at once."""


class Routine(NamedTuple):
    """A routine: its name, the places of its lines in the program, its flow, of which there is one for all that is made of the same lines.

    ``entry``: what it starts with when something calls it that nobody can see; None: nothing does.
    """

    name: str
    rows: Sequence[int]
    graph: Graph
    entry: Env | None
    files: Sequence[str] | None = None
    """The files of its lines, where it is made from several or stands in another one."""
    shared: bool = False
    """Whether its lines may be those of other routines as well, wherever they stand: what goes wrong in them must do so in all."""
    between: str | None = None
    """The file whose other lines, between these, only lead on to the next of them."""

    def is_elsewhere(self, file: str) -> bool:
        """Whether none of its lines stands in a file, so that it only tells what its callers see of it."""
        return self.files is not None and not self.shared and file not in self.files


class Program:
    """The values of a program, routine by routine."""

    def __init__(self, routines: Mapping[str, Routine], general: bool = False) -> None:
        """``general``: whatever routines are called with, and whatever is written where a variable is set once and for all."""
        self.routines = routines
        self.is_general = general
        self.solved: dict[str, Solved] = {}
        self._entries: dict[str, Env] = {}
        self._grown: Counter[tuple[str, bool]] = Counter()
        self._waiting: set[str] = set()
        self._active: list[str] = []
        self._is_settled = False
        """Whether nothing grows any more, and calls are only noted."""
        graphs = {name: routine.graph for name, routine in routines.items()}
        order = callers_first(graphs)
        self._rank = {name: at for at, name in enumerate(order)}
        self._summaries = unknown(graphs, order)
        self._callers: dict[str, list[str]] = {name: [] for name in routines}
        for name, graph in graphs.items():
            for callee in sorted(graph.callees & routines.keys()):
                self._callers[callee].append(name)

    @cached_property
    def general(self) -> Program:
        """The same, as it is whatever its routines are called with and its constants are; itself where nothing hangs on these."""
        graphs = [routine.graph for routine in self.routines.values()]
        alone = self.is_general or not any(graph.callees or graph.constants for graph in graphs)
        return self if alone else Program(self.routines, general=True)

    def forgotten(self, graph: Graph) -> frozenset[Key]:
        """The variables of a routine of which nothing is to be known."""
        return graph.constants if self.is_general else frozenset()

    def entry(self, name: str) -> Env:
        """What a routine is called with, all calls together."""
        return self._entries[name]

    def summary(self, label: str) -> Summary | None:
        """What is known of a routine; None: it is none of this program."""
        return self._summaries.get(label)

    def solving(self) -> Iterator[None]:
        """Find the values, in work that can be left at each step."""
        fit(sum(len(routine.graph.nodes) for routine in self.routines.values()))
        for routine in self.routines.values():
            if routine.entry is not None:
                self._enter(routine.name, routine.entry)
        while self._waiting:
            # Who calls goes first: it has what it calls gone through as it comes by, in the order in which the program runs.
            name = min(self._waiting, key=self._rank.__getitem__)
            self._waiting.discard(name)
            yield from self._solve(name)
        self._is_settled = True
        for _ in range(_BACK):
            changed = self._narrowed()
            for name in changed:
                yield from self._solve_again(name)
            for name in [
                name for name, solved in self.solved.items() if name not in changed and not self.tells(solved)
            ]:
                yield from self._solve_again(name)
            if not changed:
                break

    def _narrowed(self) -> list[str]:
        """Have routines start with what they are really called with, now that no guess of a loop is left; those that this changes."""
        found = {routine.name: routine.entry for routine in self.routines.values() if routine.entry is not None}
        for solved in self.solved.values():
            unseen = [(name, dict[Key, Value]()) for name in self.routines] if solved.is_blind else ()
            for name, env in (*solved.called.items(), *unseen):
                own = self._own(name, env)
                found[name] = again(join, found[name], own) if name in found else own
        changed = [name for name in self.solved if name in found and not _is_same(found[name], self._entries[name])]
        self._entries.update((name, found[name]) for name in changed)
        return changed

    def _solve_again(self, name: str) -> Iterator[None]:
        """All that went in holds, so that what comes out does."""
        solved = self.solved[name] = yield from self._found(name, self._entries[name])
        old = self._summaries[name]
        self._summaries[name] = old._replace(env=_left(solved.returned, old))

    def _solve(self, name: str) -> Iterator[None]:
        self._active.append(name)
        entry = self._entries[name]
        solved = self.solved[name] = yield from self._found(name, entry)
        self._active.pop()
        if entry is self._entries[name] and name in self._waiting and self.tells(solved):
            # What was found on the way was found in time.
            self._waiting.remove(name)
        elif not self.tells(solved):
            self._queue(name)
        self._leave(name, solved.returned)
        # With what it asked first, each is called already.
        for callee, env in solved.further.items():
            self._called(callee, env)
        if solved.is_blind:
            for other in self.routines:
                self._called(other, {})

    def tells(self, solved: Solved) -> bool:
        """Whether what a routine was told of others is still what is known of them."""
        return all(self._summaries.get(label) == told for label, _, told in solved.asked)

    def _found(self, name: str, entry: Env) -> Generator[None, None, Solved]:
        graph = self.routines[name].graph
        return gone_through(graph, entry, self, self.forgotten(graph))

    def answer(self, label: str, env: Env) -> Summary | None:
        """What is known of a routine that is called for the first time: it is gone through at once, so that its caller need not wait for it."""
        if not self._is_settled and label in self._summaries:
            self._called(label, env)
            if label in self._waiting and self._is_awaited(label):
                self._waiting.discard(label)
                for _ in self._solve(label):
                    pass
        return self.summary(label)

    def _is_awaited(self, label: str) -> bool:
        """Whether a routine is gone through before the one goes on that calls it now."""
        if label in self._active or len(self._active) >= _DEEPEST:
            return False
        return label not in self.solved or not self.routines[self._active[-1]].graph.hasty

    def _called(self, name: str, env: Env) -> None:
        self._enter(name, self._own(name, env))

    def _own(self, name: str, env: Env) -> Env:
        """What a routine starts with that is called with some values."""
        own = self.routines[name].graph.locals
        return again(_with_unset, env, own) if own else env

    def _enter(self, name: str, env: Env) -> None:
        old = self._entries.get(name)
        if old is not None and _is_same(env, old):
            return
        if old is not None:
            env = self._merge(name, False, old, env)
        if env is not old:
            self._entries[name] = env
            self._queue(name)

    def places(self, file: str, row: int) -> Iterator[tuple[Routine, Solution, list[int]]]:
        """The routines that have a line, with their values and with the nodes of that line."""
        for name, solved in self.solved.items():
            routine = self.routines[name]
            nodes = _at(routine, file, row)
            if nodes:
                yield routine, solved.solution, nodes

    def value(self, file: str, row: int, key: Key, behind: bool) -> Value | None:
        """What a variable holds before a line of a program, or behind it; None: nobody knows, or nothing comes there."""
        envs: list[Env] = []
        for _, solution, nodes in self.places(file, row):
            if behind:
                nodes = [to for node in nodes for to in solution.targets(node) if list(solution.sources(to)) == [node]]
            envs += [solution.before[node] for node in nodes if node in solution.before]
        for name, solved in self.solved.items() if not envs else ():
            env = _between(self.routines[name], solved.solution, file, row)
            envs += [env] if env is not None else []
        return reduce(joined, (env[key] for env in envs)) if envs and all(key in env for env in envs) else None

    def _leave(self, name: str, returned: Env | None) -> None:
        old = self._summaries[name]
        env = _left(returned, old)
        if env is None or old.env is None:
            env = old.env if env is None else env
        elif not _is_same(env, old.env):
            env = self._merge(name, True, old.env, env)
        else:
            env = old.env
        if env is not old.env:
            self._summaries[name] = old._replace(env=env)
            for caller in self._callers[name]:
                if caller in self._entries:
                    self._queue(caller)

    def _merge(self, name: str, leaving: bool, old: Env, new: Env) -> Env:
        found = again(join, old, new)
        if _is_same(found, old):
            return old
        self._grown[name, leaving] += 1
        return again(widen, old, new) if self._grown[name, leaving] > _PATIENCE else found

    def _queue(self, name: str) -> None:
        self._waiting.add(name)


def _left(env: Env | None, summary: Summary) -> Env | None:
    """Of what a routine returns with, what it may have set."""
    return env if env is None or summary.written is None else again(_among, env, summary.written)


def _among(env: Env, keys: frozenset[Key]) -> Env:
    return {key: value for key, value in env.items() if key in keys}


def _with_unset(env: Env, keys: frozenset[Key]) -> Env:
    return {**env, **unset(keys, True)}


def _is_same(one: Env, two: Env) -> bool:
    """Whether two hold the same: those of a program that was edited elsewhere are mostly one object."""
    return one is two or one == two


def _between(routine: Routine, solution: Solution, file: str, row: int) -> Env | None:
    """What comes to a line between those of a routine; None: nothing, or it is none."""
    if routine.between != file or routine.files is None or _at(routine, file, row):
        return None
    lines = (at for at, each in enumerate(routine.files) if each == file and routine.rows[at] > row)
    following = next(lines, None)
    if following is None:
        return solution.ending
    return solution.before.get(min(at for at, node in routine.graph.nodes.items() if node.line == following))


def _at(routine: Routine, file: str, row: int) -> list[int]:
    """The nodes of a line: of all places at which its file is put in."""
    if routine.files is None:
        at = bisect_left(routine.rows, row)
        lines = {at} if at < len(routine.rows) and routine.rows[at] == row else set()
    else:
        lines = {at for at, each in enumerate(routine.files) if each == file and routine.rows[at] == row}
    return [number for number, node in routine.graph.nodes.items() if node.line in lines] if lines else []
