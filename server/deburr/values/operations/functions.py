"""Functions of one value that rise, fall or round. Knows no language."""

from __future__ import annotations

import math

from deburr.arithmetic import Refusal
from deburr.values.domain import UNITS, WILD, Value
from deburr.values.operations.lifting import Lifted, One, higher, is_lost, lower


def rising(apply: One, first: float, last: float, least: float = -math.inf) -> Lifted:
    """A function of which a greater argument never gives less, taken from ``first`` to ``last``; it gives ``least`` at least."""

    def found(a: Value) -> Value:
        if a.wild:
            return WILD
        if a.high < first or a.low > last:
            apply(a.high if a.high < first else a.low)
        low, high = max(a.low, first), min(a.high, last)
        return Value(max(least, lower(_at(apply, low, -1))), higher(_at(apply, high, 1)))

    return found


def falling(apply: One, first: float, last: float) -> Lifted:
    """The same of one that falls."""

    def found(a: Value) -> Value:
        if a.wild:
            return WILD
        if a.high < first or a.low > last:
            apply(a.high if a.high < first else a.low)
        return Value(lower(apply(min(a.high, last))), higher(apply(max(a.low, first))))

    return found


def rounded(apply: One) -> Lifted:
    """A function to integers."""

    def found(a: Value) -> Value:
        if a.wild:
            return WILD
        low, high = (apply(each) if math.isfinite(each) else each for each in (a.low, a.high))
        return Value(low, high, UNITS if low < high else 0)

    return found


def within(low: float, high: float) -> Lifted:
    """An operation of which only its bounds are known."""
    return lambda *values: WILD if is_lost(values[0], values[-1]) else Value(low, high)


def magnitude(a: Value) -> Value:
    """An absolute value."""
    if a.wild:
        return WILD
    if a.low >= 0:
        return a
    if a.high <= 0:
        return negative(a)
    return Value(0.0, max(-a.low, a.high), UNITS if a.whole else 0, a.holed)


def negative(a: Value) -> Value:
    """A value with the other sign."""
    return a if a.empty else a._replace(low=-a.high, high=-a.low)


def _at(apply: One, number: float, sign: int) -> float:
    """The function at a bound; where it has no value there, the range has no bound."""
    if not math.isfinite(number):
        return sign * math.inf
    try:
        return apply(number)
    except (Refusal, ValueError):
        return sign * math.inf
