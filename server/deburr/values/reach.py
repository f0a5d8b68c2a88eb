"""What routines reach through their calls: whom, and which variables. Knows no values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

from deburr.values.graph import Summary

if TYPE_CHECKING:
    from deburr.values.graph import Graph, Key


def callers_first(graphs: Mapping[str, Graph]) -> list[str]:
    """The routines so that each stands before those that it calls, as far as they do not call each other."""
    found: dict[str, None] = {}
    for name in graphs:
        found.update(dict.fromkeys(_callees_first(name, graphs, found)))
    return list(reversed(found))


def _callees_first(name: str, graphs: Mapping[str, Graph], done: Mapping[str, None]) -> Iterator[str]:
    if name in done:
        return
    seen = {name}
    around = [(name, iter(sorted(graphs[name].callees & graphs.keys())))]
    while around:
        at, callees = around[-1]
        callee = next((each for each in callees if each not in seen and each not in done), None)
        if callee is None:
            around.pop()
            yield at
        else:
            seen.add(callee)
            around.append((callee, iter(sorted(graphs[callee].callees & graphs.keys()))))


def unknown(graphs: Mapping[str, Graph], order: Sequence[str]) -> dict[str, Summary]:
    """What is known of routines before any was gone through: nothing but the variables that they and all that they call read and set."""
    touched = {name: _both(graph.reads, graph.writes) for name, graph in graphs.items()}
    written = {name: graph.writes for name, graph in graphs.items()}
    rank = {name: at for at, name in enumerate(order)}
    around = any(rank[callee] <= rank[name] for name in order for callee in graphs[name].callees if callee in rank)
    for reached in (touched, written):
        # Once is enough where none calls itself through others.
        while _spread(reached, graphs, order) and around:
            pass
    return {name: Summary(None, touched[name], written[name], graphs[name].mentions) for name in order}


def _spread(reached: dict[str, frozenset[Key] | None], graphs: Mapping[str, Graph], order: Sequence[str]) -> bool:
    """Add to each what those reach that it calls; whether that changed anything."""
    changed = False
    for name in reversed(order):
        old = found = reached[name]
        for callee in graphs[name].callees:
            found = _both(found, reached.get(callee))
        if found is not old:
            reached[name], changed = found, True
    return changed


@lru_cache(maxsize=4_096)
def _both(one: frozenset[Key] | None, two: frozenset[Key] | None) -> frozenset[Key] | None:
    """All of both: the first itself where it has them, and the same object whenever the same is asked."""
    return None if one is None or two is None else one if two <= one else one | two
