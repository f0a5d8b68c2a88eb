"""How operands of conditions stand to each other: which of two variables is the greater, and before or behind which texts one comes (spec/metagcode.md §5.3). Knows no flow."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from deburr.values.domain import ANY, NO, Value, may_be_zero, without_zero
from deburr.values.graph import Env, Telling
from deburr.values.metagcode.conditions import Item, kept, mirrored

_BEHIND = without_zero(Value(0.0, ANY.high))
_BEFORE = without_zero(Value(ANY.low, 0.0))
_HOLDS = {
    "greaterthan": (False, False, True),
    "lessthan": (True, False, False),
    "equalto": (False, True, False),
    "notequalto": (True, False, True),
}
"""Which comparisons hold where the one side is less than the other, the same, or greater."""


@dataclass(frozen=True, slots=True)
class Order(Telling):
    """A key beside the variables, for how one stands to another, or to a text: its value is below 0 where it is less, 0 where they are the same.

    ``numeric``: whether they are compared as numbers.
    """

    name: str
    other: str
    is_text: bool
    numeric: bool

    def told(self, value: Value) -> str:
        """What is known from a condition on."""
        other = f"`{self.other}`" if self.is_text else f"`|{self.other}|`"
        if value == NO:
            return f"from here on `|{self.name}|` is {other}"
        behind = value.low >= 0
        if not behind and value.high > 0:
            return f"from here on `|{self.name}|` is not {other}"
        word = "greater" if behind is not may_be_zero(value) else "less"
        negation = "not " if may_be_zero(value) else ""
        return f"from here on `|{self.name}|` is {negation}{word} than {other}"

    def is_of(self, names: Collection[str | None]) -> bool:
        """Whether one of some variables stands in it."""
        return self.name in names or (not self.is_text and self.other in names)


class Standing:
    """How the sides of one condition stand to each other."""

    def __init__(self, key: Order, relation: str) -> None:
        """``relation``: between the key's own sides."""
        self.key = key
        self.is_of_one = key.name == key.other and not key.is_text
        self._relation = relation

    def holds(self, env: Env) -> bool | None:
        """Whether the condition holds, as far as those before it say; None: it may, or may not."""
        value = self._value(env)
        ways = zip((value.low < 0, may_be_zero(value), value.high > 0), _HOLDS[self._relation])
        found = {holds for is_possible, holds in ways if is_possible}
        return found.pop() if len(found) == 1 else None

    def under(self, env: Env, holds: bool) -> Env:
        """The values where it holds, or does not."""
        old = self._value(env)
        learned = kept(old, self._relation, NO, holds)
        return env if learned == old else {**env, self.key: learned}

    def _value(self, env: Env) -> Value:
        mine = self.key
        if self.is_of_one:
            return NO
        for key, value in env.items() if mine.is_text else ():
            if isinstance(key, Order) and key.is_text and key.name == mine.name:
                if mine.other < key.other and value.low >= 0:
                    return _BEHIND
                if key.other < mine.other and value.high <= 0:
                    return _BEFORE
        return env.get(mine, ANY)


def standing(left: Item, word: str, right: Item, numeric: bool) -> Standing | None:
    """What two operands are to each other; None where the bounds of numbers say it already, or both stand in the line."""
    if left.name is None:
        return None if right.name is None else standing(right, mirrored(word), left, numeric)
    if right.name is None:
        return None if numeric else Standing(Order(left.name, right.said, True, False), word)
    if left.name <= right.name:
        return Standing(Order(left.name, right.name, False, numeric), word)
    return standing(right, mirrored(word), left, numeric)
