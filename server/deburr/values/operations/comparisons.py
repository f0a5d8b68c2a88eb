"""Comparisons and truths of values. Knows no language."""

from __future__ import annotations

import math
from collections.abc import Callable

from deburr.values.domain import EITHER, NO, UNITS, YES, Value, truth
from deburr.values.operations.lifting import Lifted, is_lost


def less(a: Value, b: Value) -> Value:
    """Whether the first is less."""
    if is_lost(a, b):
        return EITHER
    if a.high < b.low:
        return YES
    return NO if a.low >= b.high else EITHER


def at_most(within: float) -> Lifted:
    """Whether the first is not more; with ``within`` near values are taken for equal."""

    def found(a: Value, b: Value) -> Value:
        if is_lost(a, b):
            return EITHER
        if a.high <= b.low:
            return YES
        return NO if a.low > b.high and a.low - b.high >= within else EITHER

    return found


def equal(near: float) -> Lifted:
    """Whether two are nearer than ``near``, which is below 1."""

    def found(a: Value, b: Value) -> Value:
        if is_lost(a, b):
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


def _both(known: bool | None) -> tuple[bool, ...]:
    return (True, False) if known is None else (known,)


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
