"""Sums, products, quotients, rests and powers of values. Knows no language.

Rounding to the nearest double never turns an order around, so bounds that are calculated as the
numbers are bound all of them.
"""

from __future__ import annotations

import math

from deburr.values.domain import LARGEST, UNITS, WILD, Value, between, exactly, may_be_zero, moved, without_zero
from deburr.values.operations.lifting import Lifted, Two, higher, is_lost, lower, tame

_LITTLE = 1e290
"""What may be added to the greatest double, and is rounded away."""


def plus(a: Value, b: Value) -> Value:
    """A sum."""
    return WILD if is_lost(a, b) else _bounded(moved(a, b, a.low + b.low, a.high + b.high), a, b, _LITTLE)


def minus(a: Value, b: Value) -> Value:
    """A difference."""
    return WILD if is_lost(a, b) else _bounded(moved(a, b, a.low - b.high, a.high - b.low), a, b, _LITTLE)


def times(a: Value, b: Value) -> Value:
    """A product."""
    if is_lost(a, b):
        return WILD
    ys = (b.low,) if b.low == b.high else (b.low, b.high)
    corners = [x * y if x and y else 0.0 for x in (a.low, a.high) for y in ys]
    whole = a.whole and b.whole
    found = _bounded(between(min(corners), max(corners), _factor_step(a, b, whole), whole), a, b, 1.0)
    return found if may_be_zero(a) or may_be_zero(b) or not _far_from_zero(a, b) else found._replace(holed=True)


def divided(apply: Two) -> Lifted:
    """A quotient. Where the divisor can only be 0, the language says what becomes of it."""

    def found(a: Value, b: Value) -> Value:
        if b.exact and b.low == 0:
            return exactly(apply(1.0, b.low))
        b = without_zero(b)
        if is_lost(a, b) or b.low <= 0 <= b.high:
            return WILD
        corners = [_ratio(x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
        return WILD if any(map(math.isnan, corners)) else between(min(corners), max(corners))

    return found


def modulo(apply: Two) -> Lifted:
    """A rest that is never negative. Where the divisor can only be 0, the language says what becomes of it."""

    def found(a: Value, b: Value) -> Value:
        if b.exact and b.low == 0:
            return exactly(apply(1.0, b.low))
        if is_lost(a, b) or may_be_zero(b):
            return WILD
        most = max(abs(b.low), abs(b.high))
        if not (a.whole and b.whole):
            return Value(0.0, most)
        return Value(0.0, most - 1 if most <= LARGEST else most, UNITS if most > 1 else 0)

    return found


def power(apply: Two) -> Lifted:
    """A power: of bases that are not negative and exponents of one sign the corners bound it."""

    def found(a: Value, b: Value) -> Value:
        if is_lost(a, b):
            return WILD
        if a.high < 0 and b.exact and b.low % 1 != 0:
            apply(a.high, b.low)
        if a.low < 0 or not (math.isfinite(a.high) and math.isfinite(b.low) and math.isfinite(b.high)):
            return WILD
        if a.low == 0 and b.low <= 0:
            return WILD
        corners = [apply(x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
        return between(lower(min(corners)), higher(max(corners)))

    return found


def _bounded(value: Value, a: Value, b: Value, little: float) -> Value:
    """A result that stays finite, however great one operand is, because the other is ``little`` at most."""
    if not value.wild:
        return value
    return tame(value) if min(max(-a.low, a.high), max(-b.low, b.high)) <= little else value


def _factor_step(a: Value, b: Value, whole: bool) -> int:
    if a.low == a.high:
        a, b = b, a
    if b.low == b.high and b.whole and a.step:
        return a.step * abs(int(b.low))
    return UNITS if whole else 0


def _far_from_zero(a: Value, b: Value) -> bool:
    """Whether no product of theirs is so small that it becomes 0."""
    return _least(a) * _least(b) > 1e-300


def _least(value: Value) -> float:
    if value.low > 0:
        return value.low
    if value.high < 0:
        return -value.high
    return 1 / UNITS if value.step else 0.0


def _ratio(a: float, b: float) -> float:
    return a / b if math.isfinite(b) or math.isfinite(a) else math.nan
