"""What an RS274 line asks of values, compiled once for all routines that hold it, and what came of it for the values that it read. Knows no other line."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

from deburr.arithmetic.rs274 import TOLERANCE
from deburr.values.domain import Value
from deburr.values.graph import Env
from deburr.values.remembered import Changes, Remembered, learned
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


def compiled(line: Taken, settings: Mapping[str, Any]) -> Compiled:
    """A line under the settings that decide how it calculates; kept with the line."""
    key = (settings["compare"], settings["profile"])
    found: Compiled | None = line.memo.get(key)
    if found is None:
        found = line.memo[key] = Compiled(line.node, settings)
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
            return learned(env, learn(env, True)), learned(env, learn(env, False))

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


Acts = Remembered[Sequence[Put]]
"""What a plain line sets."""
