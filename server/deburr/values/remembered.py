"""What comes of a line for the values that it reads, found once for all that are the same, wherever the line stands. Knows no language."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from functools import partial
from operator import itemgetter
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

from deburr.values.graph import Env, Proof

T = TypeVar("T")
_MOST = 16
"""So many answers are kept of one line."""


class Read(Protocol):
    """The expressions of a line: what they read, and whether one may have failed since that was last denied."""

    @property
    def used(self) -> set[Hashable]:
        """The variables that they read; None among them: who knows which."""

    doubtful: bool


class Changes(NamedTuple):
    """Values that are others behind a place than before it. ``gone``: variables of which nothing is known any more."""

    new: Env
    gone: tuple[Hashable, ...] = ()

    def on(self, env: Env) -> Env:
        """The values with these."""
        if not self.new and not self.gone:
            return env
        found = {**env, **self.new}
        for key in self.gone:
            found.pop(key, None)
        return found


UNCHANGED = Changes({})
changes: Callable[[tuple[Env, tuple[Hashable, ...]]], Changes] = partial(tuple.__new__, Changes)
"""Changes of their fields, made without the call of Python that their name costs."""


def learned(before: Env, behind: Env | None) -> Changes | None:
    """What a condition says of what it reads; None: it never holds so."""
    if behind is None or behind is before:
        return None if behind is None else UNCHANGED
    new = {key: value for key, value in behind.items() if before.get(key) is not value}
    return changes((new, tuple([key for key in before if key not in behind])))


def stored(behind: Env, keys: Sequence[Hashable]) -> Changes:
    """What a line that always sets the same variables has set."""
    if not keys:
        return UNCHANGED
    new = {key: behind[key] for key in keys if key in behind}
    return changes((new, () if len(new) == len(keys) else tuple([key for key in keys if key not in behind])))


class _Told(NamedTuple):
    """What came of a line that failed, or may fail."""

    found: Any
    proof: Proof | None
    doubtful: bool


class Remembered(Generic[T]):
    """What comes of a line: found once for all values that are the same in what it reads."""

    __slots__ = ("_expressions", "_find", "_kept", "_read")

    def __init__(self, expressions: Read, find: Callable[[Env], T]) -> None:
        """``expressions``: all of the line, compiled by now, so that they know what it reads. ``find`` gives no None."""
        self._expressions = expressions
        self._find = find
        self._read = None if None in expressions.used else _reader(tuple(expressions.used))
        self._kept: dict[object, T | _Told] = {}

    def of(self, env: Env) -> T:
        """What comes of it with some values; it raises the `Proof` that nothing can."""
        if self._read is None:
            self._expressions.doubtful = False
            return self._find(env)
        key = self._read(env)
        known = self._kept.get(key)
        if known is None:
            if len(self._kept) == _MOST:
                self._kept.clear()
            known = self._kept[key] = self._found(env)
        if not isinstance(known, _Told):
            self._expressions.doubtful = False
            return known
        self._expressions.doubtful = known.doubtful
        if known.proof is not None:
            raise known.proof.with_traceback(None)
        found: T = known.found
        return found

    def _found(self, env: Env) -> T | _Told:
        self._expressions.doubtful = False
        try:
            found = self._find(env)
        except Proof as proof:
            return _Told(None, proof.with_traceback(None), self._expressions.doubtful)
        return _Told(found, None, True) if self._expressions.doubtful else found


def _reader(names: tuple[Hashable, ...]) -> Callable[[Env], object]:
    """What gives the values of some variables as a key."""
    if not names:
        return lambda env: ()
    pick = itemgetter(*names)

    def read(env: Env) -> object:
        try:
            return pick(env)
        except KeyError:
            # One more than where all are there, so that no key is taken for another.
            return (None, *[env.get(name) for name in names])

    return read
