"""Operations on ranges of doubles, lifted from a language's own on numbers: what is exact is calculated by them alone. Knows no language.

Rounding to the nearest double never turns an order around, so bounds that are calculated as the
numbers are bound all of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from deburr.arithmetic import Refusal
from deburr.values.domain import (
    ANY,
    EITHER,
    LARGEST,
    NO,
    NOTHING,
    UNITS,
    WILD,
    YES,
    Value,
    between,
    exactly,
    joined,
    may_be_zero,
    moved,
    truth,
    without_zero,
)

One = Callable[[float], float]
Two = Callable[[float, float], float]
_LITTLE = 1e290
"""What may be added to the greatest double, and is rounded away."""
Lifted = Callable[..., Value]
"""An operation on values. It raises `Refusal` where the control refuses all that they hold."""


def lifted(apply: Callable[..., float], on_ranges: Lifted, operands: int = 2) -> Lifted:
    """An operation on values: of exact ones what the language says, of others what ``on_ranges`` says."""

    def of_one(a: Value) -> Value:
        if a.low == a.high and not a.wild:
            return exactly(apply(a.low))
        return NOTHING if a.impossible else on_ranges(a)

    def of_two(a: Value, b: Value) -> Value:
        if a.low == a.high and b.low == b.high and not a.wild and not b.wild:
            return exactly(apply(a.low, b.low))
        return NOTHING if a.impossible or b.impossible else on_ranges(a, b)

    return of_one if operands == 1 else of_two


def plus(a: Value, b: Value) -> Value:
    """A sum."""
    return WILD if _lost(a, b) else _bounded(moved(a, b, a.low + b.low, a.high + b.high), a, b, _LITTLE)


def minus(a: Value, b: Value) -> Value:
    """A difference."""
    return WILD if _lost(a, b) else _bounded(moved(a, b, a.low - b.high, a.high - b.low), a, b, _LITTLE)


def times(a: Value, b: Value) -> Value:
    """A product."""
    if _lost(a, b):
        return WILD
    corners = [x * y if x and y else 0.0 for x in (a.low, a.high) for y in (b.low, b.high)]
    whole = a.whole and b.whole
    found = _bounded(between(min(corners), max(corners), _factor_step(a, b), whole), a, b, 1.0)
    return found if may_be_zero(a) or may_be_zero(b) else found._replace(holed=_far_from_zero(a, b))


def divided(apply: Two) -> Lifted:
    """A quotient. Where the divisor can only be 0, the language says what becomes of it."""

    def found(a: Value, b: Value) -> Value:
        if b.exact and b.low == 0:
            return exactly(apply(1.0, b.low))
        b = without_zero(b)
        if _lost(a, b) or b.low <= 0 <= b.high:
            return WILD
        corners = [_ratio(x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
        return WILD if any(map(math.isnan, corners)) else between(min(corners), max(corners))

    return found


def modulo(apply: Two) -> Lifted:
    """A rest that is never negative. Where the divisor can only be 0, the language says what becomes of it."""

    def found(a: Value, b: Value) -> Value:
        if b.exact and b.low == 0:
            return exactly(apply(1.0, b.low))
        if _lost(a, b) or may_be_zero(b):
            return WILD
        most = max(abs(b.low), abs(b.high))
        if not (a.whole and b.whole):
            return Value(0.0, most)
        return Value(0.0, most - 1 if most <= LARGEST else most, UNITS if most > 1 else 0)

    return found


def power(apply: Two) -> Lifted:
    """A power: of bases that are not negative and exponents of one sign the corners bound it."""

    def found(a: Value, b: Value) -> Value:
        if _lost(a, b):
            return WILD
        if a.high < 0 and b.exact and b.low % 1 != 0:
            apply(a.high, b.low)
        if a.low < 0 or not (math.isfinite(a.high) and math.isfinite(b.low) and math.isfinite(b.high)):
            return WILD
        if a.low == 0 and b.low <= 0:
            return WILD
        corners = [apply(x, y) for x in (a.low, a.high) for y in (b.low, b.high)]
        return between(_less(min(corners)), _more(max(corners)))

    return found


def rising(apply: One, first: float, last: float, least: float = -math.inf) -> Lifted:
    """A function of which a greater argument never gives less, taken from ``first`` to ``last``; it gives ``least`` at least."""

    def found(a: Value) -> Value:
        if a.wild:
            return WILD
        if a.high < first or a.low > last:
            apply(a.high if a.high < first else a.low)
        low, high = max(a.low, first), min(a.high, last)
        return Value(max(least, _less(_at(apply, low, -1))), _more(_at(apply, high, 1)))

    return found


def falling(apply: One, first: float, last: float) -> Lifted:
    """The same of one that falls."""

    def found(a: Value) -> Value:
        if a.wild:
            return WILD
        if a.high < first or a.low > last:
            apply(a.high if a.high < first else a.low)
        return Value(_less(apply(min(a.high, last))), _more(apply(max(a.low, first))))

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
    return lambda *values: WILD if _lost(*values) else Value(low, high)


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


def finite(value: Value) -> Value:
    """What is left where the control looks whether a result is a number."""
    if value.wild and value.empty:
        raise Refusal("not-finite", "a result that is no finite number")
    return value._replace(wild=False)


def less(a: Value, b: Value) -> Value:
    """Whether the first is less."""
    if _lost(a, b):
        return EITHER
    if a.high < b.low:
        return YES
    return NO if a.low >= b.high else EITHER


def at_most(within: float) -> Lifted:
    """Whether the first is not more; with ``within`` near values are taken for equal."""

    def found(a: Value, b: Value) -> Value:
        if _lost(a, b):
            return EITHER
        if a.high <= b.low:
            return YES
        return NO if a.low > b.high and a.low - b.high >= within else EITHER

    return found


def equal(near: float) -> Lifted:
    """Whether two are nearer than ``near``, which is below 1."""

    def found(a: Value, b: Value) -> Value:
        if _lost(a, b):
            return EITHER
        if max(a.high - b.low, b.high - a.low) < near:
            return YES
        if a.low - b.high >= near or b.low - a.high >= near:
            return NO
        return NO if a.whole and b.whole and _never_meet(a, b) else EITHER

    return found


def swapped(apply: Lifted) -> Lifted:
    """The same with the sides exchanged."""
    return lambda a, b: apply(b, a)


def negated(apply: Lifted) -> Lifted:
    """The opposite of a comparison of finite numbers."""

    def found(a: Value, b: Value) -> Value:
        value = apply(a, b)
        return NO if value == YES else YES if value == NO else EITHER

    return found


def logical(table: Callable[[bool, bool], bool]) -> Lifted:
    """An operation on truths."""

    def found(a: Value, b: Value) -> Value:
        one, two = truth(a), truth(b)
        sides = [(x, y) for x in ((one,) if one is not None else (True, False)) for y in _both(two)]
        values = [YES if table(x, y) else NO for x, y in sides]
        return values[0] if all(value == values[0] for value in values) else EITHER

    return found


def union(values: list[Value]) -> Value:
    """What is in any of them."""
    found = values[0] if values else ANY
    for value in values[1:]:
        found = joined(found, value)
    return found


def _bounded(value: Value, a: Value, b: Value, little: float) -> Value:
    """A result that stays finite, however great one operand is, because the other is ``little`` at most."""
    small = min(max(-a.low, a.high), max(-b.low, b.high)) <= little
    return value._replace(wild=False) if value.wild and small else value


def _both(known: bool | None) -> tuple[bool, ...]:
    return (True, False) if known is None else (known,)


def _lost(*values: Value) -> bool:
    """Whether nothing is known of what comes of them."""
    return any(value.wild or value.empty for value in values)


def _factor_step(a: Value, b: Value) -> int:
    if a.low == a.high:
        a, b = b, a
    if b.low == b.high and b.whole and a.step:
        return a.step * abs(int(b.low))
    return UNITS if a.whole and b.whole else 0


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


def _never_meet(a: Value, b: Value) -> bool:
    """Whether two grids of integers have no number in common."""
    if not all(map(math.isfinite, (a.low, a.high, b.low, b.high))):
        return False
    step = math.gcd(a.step, b.step)
    if not step:
        return not a.has(b.low) if b.low == b.high else not b.has(a.low)
    if a.low == a.high:
        return not b.has(a.low)
    return not a.has(b.low) if b.low == b.high else (int(a.low) - int(b.low)) * UNITS % step != 0


def _at(apply: One, number: float, sign: int) -> float:
    """The function at a bound; where it has no value there, the range has no bound."""
    if not math.isfinite(number):
        return sign * math.inf
    try:
        return apply(number)
    except (Refusal, ValueError):
        return sign * math.inf


def _less(number: float) -> float:
    """A little below: functions of the library may be off by the last digits."""
    return number - abs(number) * 1e-14 - 1e-300 if math.isfinite(number) else number


def _more(number: float) -> float:
    return number + abs(number) * 1e-14 + 1e-300 if math.isfinite(number) else number
