"""How a value comes to stand in a Z32 parameter. Calculates nothing."""

from __future__ import annotations

from collections.abc import Callable

from deburr.values.domain import ANY, Value
from deburr.values.graph import Env
from deburr.values.remembered import Changes, changes


def put(env: Env, name: str, value: Value) -> Env:
    """The values with another one for a parameter."""
    if value != ANY:
        return {**env, name: value}
    return {key: old for key, old in env.items() if key != name} if name in env else env


class Stored:
    """What calculates a value and stores it in a parameter that the line alone tells."""

    __slots__ = ("_get", "_key")

    def __init__(self, key: str, get: Callable[[Env], Value]) -> None:
        self._key = key
        self._get = get

    def __call__(self, env: Env) -> Env:
        """The values behind it."""
        return put(env, self._key, self._get(env))

    def changes(self, env: Env) -> Changes:
        """The same as what it changes."""
        value = self._get(env)
        return changes(({self._key: value}, ()) if value != ANY else ({}, (self._key,)))
