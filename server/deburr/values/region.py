"""The loops of a routine that stand in no other one, and what came of each when it was last gone through. Knows no language."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from deburr.values.graph import RETURN, Env, Graph, Head, Key, Proof


class Outcome(NamedTuple):
    """What came of a region: of each node that is reached which values come to it, and on which ways it goes on with which. They are told by their places in ``envs``.

    ``key``: what came to it; ``envs``: the values of what concerns it.
    """

    key: object
    nodes: Sequence[tuple[int, int, Sequence[tuple[int, int]]]]
    envs: Sequence[Env]
    proofs: Mapping[int, Proof]
    remarks: Mapping[int, Proof]
    doubtful: set[int]


class Parts:
    """Values of some variables, each set of them once."""

    def __init__(self, keys: frozenset[Key]) -> None:
        self._keys = keys
        self._places: dict[int, int] = {}
        self.envs: list[Env] = []

    def add(self, env: Env) -> int:
        """The place of what these variables hold, of values that are kept elsewhere meanwhile."""
        place = self._places.get(id(env))
        if place is None:
            place = self._places[id(env)] = len(self.envs)
            self.envs.append({key: value for key, value in env.items() if key in self._keys})
        return place


class Region:
    """Loops in each other, or loops that overlap: their heads, and their first and last node."""

    def __init__(self, graph: Graph, heads: Sequence[int], last: int) -> None:
        self.heads = heads
        self.first = heads[0]
        self.last = last
        nodes = [graph.nodes[at] for at in range(self.first, last + 1) if at in graph.nodes]
        keys = graph.hidden.union(*[node.used | node.sets for node in nodes]) if graph.hidden is not None else None
        calls = any(node.calls for node in nodes)
        self.keys: frozenset[Key] = frozenset() if keys is None or calls or None in keys else keys
        """The variables that concern it, where these are known: it reads and sets no other one."""
        self._order = tuple(self.keys)
        self.found: Outcome | None = None

    def key(self, env: Env | None, forgotten: frozenset[Key]) -> object:
        """All that what comes of it hangs on; None: nobody knows."""
        if env is None or not self._order:
            return None
        return forgotten, [env.get(key) for key in self._order]


def regions(graph: Graph) -> Sequence[Region]:
    """The regions of a routine, in order."""
    found: Sequence[Region] | None = graph.memo.get("regions")
    if found is None:
        end = max(graph.nodes, default=RETURN)
        found = graph.memo["regions"] = [Region(graph, *each) for each in _outermost(graph.heads, end)]
    return found


def calling(graph: Graph) -> Sequence[int]:
    """The nodes of a routine that call."""
    found: Sequence[int] | None = graph.memo.get("calling")
    if found is None:
        found = graph.memo["calling"] = [at for at, node in graph.nodes.items() if node.calls]
    return found


def _outermost(heads: Mapping[int, Head], end: int) -> list[tuple[list[int], int]]:
    """The loops that stand in no other one, in order: the heads in each, and its last node. Loops that overlap count as one.

    Of one into which ways lead from elsewhere the head does not tell where it ends: it is taken for all that follows.
    """
    found: list[tuple[list[int], int]] = []
    for head in sorted(heads):
        last = heads[head].last if heads[head].last >= head else end
        if found and head <= found[-1][1]:
            inside, before = found.pop()
            found.append(([*inside, head], max(last, before)))
        else:
            found.append(([head], last))
    return found
