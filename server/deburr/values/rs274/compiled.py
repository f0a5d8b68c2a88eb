"""What an RS274 line asks of values, compiled once for all routines that hold it, and what came of it for the values that it read. Knows no other line."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, NamedTuple, TypeVar

from deburr.arithmetic.rs274 import TOLERANCE
from deburr.values.domain import Value
from deburr.values.graph import Env, Proof
from deburr.values.rs274.conditions import Conditions
from deburr.values.rs274.expressions import Expressions
from deburr.values.rs274.keys import Put, set_by
from deburr_grammar.dialects.rs274.outline import label_of
from deburr_grammar.tree import Node as Part
from deburr_grammar.tree import Token, walk

if TYPE_CHECKING:
    from deburr.values.rs274.expressions import Get
    from deburr.values.rs274.lines import Taken
    from deburr_grammar.line import LineNode

T = TypeVar("T")
_MOST = 16
"""So many answers are kept of one line."""


def compiled(line: Taken, settings: Mapping[str, Any]) -> Compiled:
    """A line under the settings that decide how it calculates; kept with the line."""
    key = (settings["compare"], settings["profile"])
    found: Compiled | None = line.memo.get(key)
    if found is None:
        found = line.memo[key] = Compiled(line.node, settings)
    return found


class Changes(NamedTuple):
    """The values where a condition holds, as far as they are others than before it. ``gone``: parameters of which nothing is known any more."""

    new: Env
    gone: tuple[Hashable, ...]

    def on(self, env: Env) -> Env:
        """The values with these."""
        if not self.new and not self.gone:
            return env
        found = {**env, **self.new}
        for key in self.gone:
            del found[key]
        return found


class Compiled:
    """One line. What it is made of is compiled when it is first asked for, always in the same order."""

    def __init__(self, line: LineNode, settings: Mapping[str, Any]) -> None:
        self._line = line
        self.expressions = Expressions(line, settings)
        self._tolerance = TOLERANCE[settings["compare"]]

    @cached_property
    def o_line(self) -> Part | None:
        """The part that holds the O-word, in columns of the shape."""
        return next((part for part in self._tree.nodes() if part.kind == "o_line"), None)

    @cached_property
    def groups(self) -> list[Part]:
        """The brackets behind an O-word, in columns of the shape."""
        return [part for part in self.o_line.nodes() if part.kind == "group"] if self.o_line is not None else []

    @cached_property
    def label(self) -> str | None:
        """The label of a call, if the line tells it."""
        part = next(self._line.find("label"), None)
        return label_of(self._line.text, part) if part is not None else None

    @property
    def settings(self) -> list[Part]:
        """What it sets: parameters, in columns of the shape."""
        found = [part.children[0] for part in walk(self._tree) if isinstance(part, Part) and part.kind == "setting"]
        return [param for param in found if isinstance(param, Part)]

    @property
    def _tree(self) -> Part:
        return self._line.shape.tree(self._line.reading)

    @cached_property
    def values(self) -> Remembered[list[Value]]:
        """What the brackets hold."""
        return self._all(self.groups)

    @cached_property
    def arguments(self) -> Remembered[list[Value]]:
        """What a call passes; the label is calculated before."""
        label = self.o_line.node("label") if self.o_line is not None else None
        computed = self._all(label.children[:1]) if label is not None and self.label is None else None
        return self._all(self.groups, computed)

    def _all(
        self, parts: Sequence[Part | Token], first: Remembered[list[Value]] | None = None
    ) -> Remembered[list[Value]]:
        gets = [self.expressions.value(part) for part in parts]

        def found(env: Env) -> list[Value]:
            if first is not None:
                first.of(env)
            return [get(env) for get in gets]

        return Remembered(self.expressions, found)

    @cached_property
    def ways(self) -> Remembered[tuple[Changes | None, Changes | None]]:
        """What the values are where a condition holds, and where it does not; None: it never does."""
        learn, get = (
            Conditions(self.expressions, self._tolerance).learn(self.groups[0]),
            self.expressions.value(self.groups[0]),
        )

        def found(env: Env) -> tuple[Changes | None, Changes | None]:
            get(env)
            return _changes(env, learn(env, True)), _changes(env, learn(env, False))

        return Remembered(self.expressions, found)

    @cached_property
    def acts(self) -> tuple[Acts | None, tuple[Hashable, ...]]:
        """What a plain line sets, and which parameters these may be. None: it asks nothing and sets nothing."""
        expressions = self.expressions
        settings: list[tuple[Callable[[Env], tuple[Hashable, ...] | None], Get]] = []
        words: list[Get] = []
        sets: list[Hashable] = []
        for part in (child.children[0] for child in self._tree.nodes() if child.kind == "item"):
            if not isinstance(part, Part):
                continue
            if part.kind == "setting" and isinstance(param := part.children[0], Part):
                settings.append((expressions.target(param), expressions.value(part.children[2])))
                sets.append(set_by(expressions, param))
            elif part.kind == "word" and not isinstance(part.children[1], Token):
                words.append(expressions.value(part.children[1]))
        if not settings and not words:
            return None, ()

        def found(env: Env) -> Sequence[Put]:
            puts = [(target(env), get(env)) for target, get in settings] if settings else ()
            for get in words:
                get(env)
            return puts

        return Remembered(expressions, found), tuple(sets)


class _Told(NamedTuple):
    """What came of a line that failed, or may fail."""

    found: Any
    proof: Proof | None
    doubtful: bool


class Remembered(Generic[T]):
    """What comes of a line: found once for all values that are the same in what it reads."""

    __slots__ = ("_expressions", "_find", "_kept", "_used")

    def __init__(self, expressions: Expressions, find: Callable[[Env], T]) -> None:
        """``expressions``: all of the line, compiled by now, so that they know what it reads. ``find`` gives no None."""
        self._expressions = expressions
        self._find = find
        self._used = None if None in expressions.used else tuple(expressions.used)
        self._kept: dict[tuple[Value | None, ...], T | _Told] = {}

    def of(self, env: Env) -> T:
        """What comes of it with some values; it raises the `Proof` that nothing can."""
        if self._used is None:
            self._expressions.doubtful = False
            return self._find(env)
        key = tuple([env.get(name) for name in self._used])
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

    def certain(self, env: Env) -> T | None:
        """The same where it neither fails nor may fail; None where it does."""
        if self._used is None:
            return None
        known = self._kept.get(tuple([env.get(name) for name in self._used]))
        if known is not None:
            return None if isinstance(known, _Told) else known
        found = self.of(env)
        return None if self._expressions.doubtful else found

    def _found(self, env: Env) -> T | _Told:
        self._expressions.doubtful = False
        try:
            found = self._find(env)
        except Proof as proof:
            return _Told(None, proof.with_traceback(None), self._expressions.doubtful)
        return _Told(found, None, True) if self._expressions.doubtful else found


Acts = Remembered[Sequence[Put]]
"""What a plain line sets."""


def _changes(before: Env, behind: Env | None) -> Changes | None:
    if behind is None or behind is before:
        return None if behind is None else _SAME
    new = {key: value for key, value in behind.items() if before.get(key) is not value}
    return Changes(new, tuple(key for key in before if key not in behind))


_SAME = Changes({}, ())
