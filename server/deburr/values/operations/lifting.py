"""Operations on numbers made operations on values: what is exact is calculated by the language's own alone. Knows no operation."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache

from deburr.arithmetic import Refusal
from deburr.values.domain import ANY, NOTHING, Value, exactly, joined

One = Callable[[float], float]
Two = Callable[[float, float], float]
Lifted = Callable[..., Value]
"""An operation on values. It raises `Refusal` where the control refuses all that they hold."""

_KEPT = 1_024


def lifted(apply: Callable[..., float], on_ranges: Lifted, operands: int = 2) -> Lifted:
    """An operation on values: of exact ones what the language says, of others what ``on_ranges`` says, which is kept."""
    on_ranges = lru_cache(maxsize=_KEPT)(on_ranges)

    def of_one(a: Value) -> Value:
        if a.low == a.high and not a.wild:
            return exactly(apply(a.low))
        return NOTHING if a.low > a.high and a.impossible else on_ranges(a)

    def of_two(a: Value, b: Value) -> Value:
        if a.low == a.high and b.low == b.high and not a.wild and not b.wild:
            return exactly(apply(a.low, b.low))
        if (a.low > a.high and a.impossible) or (b.low > b.high and b.impossible):
            return NOTHING
        return on_ranges(a, b)

    return of_one if operands == 1 else of_two


def union(values: list[Value]) -> Value:
    """What is in any of them."""
    found = values[0] if values else ANY
    for value in values[1:]:
        found = joined(found, value)
    return found


def finite(value: Value) -> Value:
    """What is left where the control looks whether a result is a number."""
    if value.wild and value.empty:
        raise Refusal("not-finite", "a result that is no finite number")
    return tame(value) if value.wild else value


def tame(value: Value) -> Value:
    """The same without what is no finite number."""
    return Value(value.low, value.high, value.step, value.holed, False, value.unset, value.texts)


def is_lost(a: Value, b: Value) -> bool:
    """Whether nothing is known of what comes of them."""
    return a.wild or b.wild or a.low > a.high or b.low > b.high


def lower(number: float) -> float:
    """A little below: functions of the library may be off by the last digits."""
    return number - abs(number) * 1e-14 - 1e-300 if math.isfinite(number) else number


def higher(number: float) -> float:
    """A little above."""
    return number + abs(number) * 1e-14 + 1e-300 if math.isfinite(number) else number
