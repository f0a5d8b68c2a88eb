"""The generator as a routine that calls sections: `@DECLARE` and `@START` once, then any in any order, then `@END` (spec/cgt.md §1, §6, §11). Knows no section's lines."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.values.cgt.outcomes import merged
from deburr.values.cgt.words import ALL, END, RETURNED, Shown, unshown, without
from deburr.values.domain import ANY, joined
from deburr.values.graph import STOP, Calls, Env, Flows, Graph, Head, Key, Node
from deburr_grammar.dialects.cgt.outline import SECTIONS

if TYPE_CHECKING:
    from deburr.formats.events import Event

NAME = " "
"""The generator's name. No section has a blank in it."""
Flow = Callable[[Env, Calls], Flows]
_ONCE = ("DECLARE", "START", "END")
_BEGIN, _DECLARE, _MODEL, _FIRST_CHANGE, _START, _NEXT, _CHANGE, _SYSTEM, _OTHERS, _BACK, _LAST_CHANGE, _END = range(12)


class Path(NamedTuple):
    """What is known of the toolpath: the sections that it may run at any time, and the words of the template that it sets."""

    runs: frozenset[str] = frozenset()
    sets: frozenset[str] = frozenset()
    free: bool = False
    """Whether it begins with another section than `@START`, or goes on behind `@END`."""


def path_of(events: Iterable[Event]) -> Path:
    """What a list of events may do that the generator does not do by itself."""
    found = list(events)
    runs = [event.section for event in found if event.section]
    inner = runs[runs[:1] == ["START"] : len(runs) - (runs[-1:] == ["END"])]
    sets = frozenset(given.name for event in found for given in event.values)
    return Path(frozenset(runs), sets, not set(_ONCE).isdisjoint(inner))


@lru_cache(maxsize=64)
def generator(sections: Sequence[str], mine: frozenset[str], path: Path) -> Graph:
    """The graph of the generator. ``mine``: words of the template, which the toolpath leaves alone."""
    listed = path.runs if path.free else path.runs - set(_ONCE)
    chosen = [name for name in sections if name in listed or not (name in _ONCE or name.startswith("$"))]
    system = [name for name in chosen if name in SECTIONS and name != "CYCLCHG"]
    others = [name for name in chosen if name not in SECTIONS]

    def once(name: str, behind: int) -> Flow:
        if name not in sections:
            return lambda env, calls: ((behind, env),)
        return lambda env, calls: _ran(name, env, calls, behind)

    def freshly(*behind: int) -> Flow:
        return lambda env, calls: tuple((to, found) for found in (_fresh(env, mine),) for to in behind)

    flows: dict[int, Flow] = {
        _BEGIN: freshly(_DECLARE),
        _DECLARE: once("DECLARE", _MODEL),
        _MODEL: freshly(_FIRST_CHANGE, _NEXT) if path.free else freshly(_FIRST_CHANGE),
        _FIRST_CHANGE: once("CYCLCHG", _START),
        _START: once("START", _NEXT),
        _NEXT: freshly(_CHANGE, _OTHERS, _LAST_CHANGE),
        _CHANGE: once("CYCLCHG", _SYSTEM),
        _SYSTEM: lambda env, calls: ((_BACK, _any_of(system, env, calls)),),
        _OTHERS: lambda env, calls: ((_BACK, _any_of(others, env, calls)),),
        _BACK: lambda env, calls: ((_NEXT, env),),
        _LAST_CHANGE: once("CYCLCHG", _END),
        _END: once("END", STOP),
    }
    nodes = {number: Node(0, flow, calls=True) for number, flow in flows.items()}
    heads = {_NEXT: Head(_BACK, lambda key: True)}
    return Graph(nodes, heads, (), frozenset(), None, None, None, frozenset(sections), hasty=True)


def _fresh(env: Env, mine: frozenset[str]) -> Env:
    """The values when the toolpath has set its words."""
    return {key: value for key, value in env.items() if _word(key) in mine}


def _word(key: Key) -> object:
    return key.name if isinstance(key, Shown) else key


def _ran(name: str, env: Env, calls: Calls, behind: int) -> Flows:
    found = calls.call(name, {}, env)
    after = merged(env, found) if found is not None else None
    return () if after is None else ((behind, without(after, END, RETURNED)),)


def _any_of(names: Sequence[str], env: Env, calls: Calls) -> Env:
    """The values behind one of some sections, or none. What a section does not set is what it was."""
    after = dict(env)
    for name in names:
        found = calls.call(name, {}, env)
        if found is None or found.env is None:
            continue
        written = found.written if found.written is not None else frozenset(after)
        if ALL in written:
            after = unshown(after)
        for key in written & after.keys():
            value = found.env.get(key)
            both = joined(after[key], value) if value is not None and key not in (END, RETURNED) else ANY
            if both == ANY:
                del after[key]
            else:
                after[key] = both
    return after
