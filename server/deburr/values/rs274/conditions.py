"""What is known of parameters where an RS274 condition holds, or does not (spec/rs274.md §3.2). Calculates nothing itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.values.domain import ANY, Value, above, apart, below, near, only_zero, truth, without_zero
from deburr.values.graph import Env
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from collections.abc import Hashable, Iterator

    from deburr.values.rs274.expressions import Expressions, Get

Learn = Callable[[Env, bool], Env | None]
_OPPOSITE = {"LT": "GE", "GE": "LT", "GT": "LE", "LE": "GT", "EQ": "NE", "NE": "EQ"}
_MIRRORED = {"LT": "GT", "GT": "LT", "LE": "GE", "GE": "LE", "EQ": "EQ", "NE": "NE"}


class Conditions:
    """Compiles what the conditions of one line teach."""

    def __init__(self, expressions: Expressions, tolerance: float) -> None:
        self._expressions = expressions
        self._near = tolerance
        self._tolerant = tolerance < 1e-4

    def learn(self, part: Node | Token) -> Learn:
        """What gives the values under which a condition is true, or false; None: it never is."""
        if isinstance(part, Node):
            match part.kind:
                case "group":
                    return self.learn(part.children[1])
                case "comparison":
                    return self._comparison(part)
                case "logical":
                    return self._logical(part)
                case "param":
                    return self._truth(part)
        return self._value_alone(part)

    def _value_alone(self, part: Node | Token) -> Learn:
        get = self._expressions.value(part)

        def learned(env: Env, holds: bool) -> Env | None:
            return env if truth(get(env)) in (None, holds) else None

        return learned

    def _truth(self, part: Node) -> Learn:
        key, get = self._key(part), self._expressions.value(part)

        def learned(env: Env, holds: bool) -> Env | None:
            value = get(env)
            return _with(env, key, value, without_zero(value) if holds else only_zero(value))

        return learned

    def _logical(self, part: Node) -> Learn:
        left, sign, right = part.children
        word = self._expressions.spelled(sign)
        alone = self._value_alone(part)
        if word == "XOR":
            return alone
        one, two = self.learn(left), self.learn(right)
        both = word == "AND"

        def learned(env: Env, holds: bool) -> Env | None:
            if holds == both:
                first = one(env, holds)
                return two(first, holds) if first is not None else None
            return alone(env, holds)

        return learned

    def _comparison(self, part: Node) -> Learn:
        left, sign, right = part.children
        word = self._expressions.spelled(sign)
        alone = self._value_alone(part)
        sides = list(self._sides(left, right, word))

        def learned(env: Env, holds: bool) -> Env | None:
            found = alone(env, holds)
            for key, get, other, relation in sides:
                if found is not None:
                    value = get(found)
                    found = _with(
                        found,
                        key,
                        value,
                        self._kept(value, relation if holds else _OPPOSITE[relation], other(found), holds),
                    )
            return found

        return learned

    def _sides(self, left: Node | Token, right: Node | Token, word: str) -> Iterator[tuple[Hashable, Get, Get, str]]:
        for side, other, relation in ((left, right, word), (right, left, _MIRRORED[word])):
            key = self._key(side)
            if key is not None:
                yield key, self._expressions.value(side), self._expressions.value(other), relation

    def _kept(self, value: Value, relation: str, other: Value, holds: bool) -> Value:
        """The values of a side that stand in this relation to one of the other's. Where the control is tolerant, a comparison that fails says no less than its opposite."""
        if other.wild or other.empty:
            return value
        match relation:
            case "LT":
                return below(value, other.high, True)
            case "GT":
                return above(value, other.low, True)
            case "LE":
                return below(value, other.high + (2 * self._near if self._tolerant and holds else 0.0), False)
            case "GE":
                return above(value, other.low - (2 * self._near if self._tolerant and holds else 0.0), False)
            case "EQ":
                return near(value, other, self._near)
            case _:
                return apart(value, other, self._near)

    def _key(self, part: Node | Token) -> Hashable:
        """The parameter that a side is, if the line alone tells which."""
        if not isinstance(part, Node) or part.kind != "param":
            return None
        name = self._expressions.name(part)
        if name is not None:
            # What the control sets may be another one on the next line.
            return None if self._expressions.is_predefined(name) else name
        return self._expressions.literal(part)


def _with(env: Env, key: Hashable, old: Value, new: Value) -> Env | None:
    """The values with another one for a parameter; None where it has none."""
    if new.impossible:
        return None
    if key is None or new == old:
        return env
    found = {**env, key: new}
    if new == ANY:
        del found[key]
    return found
