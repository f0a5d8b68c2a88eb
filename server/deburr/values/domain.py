"""What a variable can hold: a closed range of numbers, the grid they lie on, and what is known besides. Knows no language and no program."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache, partial
from typing import NamedTuple

UNITS = 1024
"""Grids are counted in units of 1/1024: fine enough for what people count in halves and quarters, and exact in doubles."""
LARGEST = 2.0**40
"""Up to this magnitude sums and differences on a grid are exact in doubles."""
TEXTS = 8
"""So many texts are told apart; of more nothing is known."""

_VAST = 1e300


class Value(NamedTuple):
    """A set of numbers: all from ``low`` to ``high`` that lie on the grid, both included.

    ``step``: the distance on the grid, in units, counted from a bound; 0: no grid is known. Beyond `LARGEST` the only grid is that of
    the integers: what is added and multiplied there is rounded, but to integers.
    ``holed``: 0 is none of them. ``wild``: it may also be no finite number. ``unset``: it may also be that nothing was set.
    ``texts``: it may also be one of these texts. With ``low`` above ``high`` no finite number is left.
    """

    low: float
    high: float
    step: int = 0
    holed: bool = False
    wild: bool = False
    unset: bool = False
    texts: frozenset[str] = frozenset()

    @property
    def exact(self) -> bool:
        """Whether it is one number and nothing else."""
        return self.low == self.high and not self.wild and not self.unset

    @property
    def empty(self) -> bool:
        """Whether there is no finite number in it."""
        return self.low > self.high

    @property
    def impossible(self) -> bool:
        """Whether nothing at all is in it: what has this value is never reached."""
        return self.low > self.high and not self.wild and not self.unset and not self.texts

    @property
    def whole(self) -> bool:
        """Whether all are integers."""
        if self.step:
            bound = self.low if math.isfinite(self.low) else self.high
            return self.step % UNITS == 0 and (bound.is_integer() or not math.isfinite(bound))
        return self.low == self.high and self.low.is_integer()

    @property
    def size(self) -> int | None:
        """How many numbers there are; None if nobody can tell."""
        if self.low == self.high:
            return 1
        small = self.step and not self.empty and self.low >= -LARGEST and self.high <= LARGEST
        return _units(self.high - self.low) // self.step + 1 if small else None

    def has(self, number: float) -> bool:
        """Whether a number is among them."""
        if not math.isfinite(number):
            return self.wild
        if not self.low <= number <= self.high or (self.holed and number == 0):
            return False
        return not self.step or (_on_grid(number) and (_units(number) - _base(self)) % self.step == 0)


_NO_TEXTS = frozenset[str]()
_value: Callable[[tuple[float, float, int, bool, bool, bool, frozenset[str]]], Value] = partial(tuple.__new__, Value)
"""A value of its fields, made without the call of Python that its name costs."""

ANY = Value(-math.inf, math.inf)
"""Any finite number."""
WILD = Value(-math.inf, math.inf, wild=True)
"""Any result, also one that is no finite number."""
UNSET = Value(math.inf, -math.inf, unset=True)
"""Nothing was set."""
NOTHING = Value(math.inf, -math.inf)
"""No value at all: what has it is never reached."""
YES, NO = Value(1.0, 1.0), Value(0.0, 0.0)
EITHER = Value(0.0, 1.0, UNITS)


def exactly(number: float) -> Value:
    """One number; of one that is not finite nothing is known but that."""
    return (
        _value((number, number, 0, False, False, False, _NO_TEXTS))
        if math.isfinite(number)
        else NOTHING._replace(wild=True)
    )


def any_of(texts: frozenset[str]) -> Value:
    """One of some texts, and no number; of many texts nothing is known."""
    return NOTHING._replace(texts=texts) if len(texts) <= TEXTS else ANY


def between(low: float, high: float, step: int = 0, whole: bool = False) -> Value:
    """A range; a bound at infinity stands for results that are not finite, too. ``whole``: whether all are integers."""
    if math.isnan(low) or math.isnan(high):
        return WILD
    is_wild = math.isinf(low) or math.isinf(high)
    return _value((low, high, _held(low, high, step, whole), False, is_wild, False, _NO_TEXTS))


def joined(one: Value, two: Value) -> Value:
    """What is in one or the other."""
    return one if one is two or one == two else _joined(one, two)


@lru_cache(maxsize=4_096)
def _joined(one: Value, two: Value) -> Value:
    wild, unset = one.wild or two.wild, one.unset or two.unset
    if one.texts or two.texts:
        return any_of(one.texts | two.texts) if one.empty and two.empty and not (wild or unset) else ANY
    if one.empty or two.empty:
        return (two if one.empty else one)._replace(wild=wild, unset=unset)
    low, high = min(one.low, two.low), max(one.high, two.high)
    step = _held(low, high, _common(one, two), one.whole and two.whole)
    return Value(low, high, step, not (may_be_zero(one) or may_be_zero(two)), wild, unset)


def widened(old: Value, new: Value) -> Value:
    """What a loop's growing value is taken for, so that it comes to rest: a bound that moves goes to the next resting place."""
    found = joined(old, new)
    if old.empty or found == old:
        return found
    low = old.low if found.low >= old.low else _rest(found.low, found)
    high = old.high if found.high <= old.high else -_rest(-found.high, found)
    step = found.step if low >= -LARGEST and high <= LARGEST else 0
    return Value(low, high, step, found.holed, found.wild, found.unset, found.texts)


def may_be_zero(value: Value) -> bool:
    """Whether 0 may be among the finite ones."""
    return value.low <= 0 <= value.high and value.has(0.0)


def truth(value: Value) -> bool | None:
    """Whether a condition of this value holds: 0 is false, all else is true; None: either."""
    if not may_be_zero(value):
        return True
    return False if value.low == value.high and not value.wild else None


def read(value: Value) -> Value:
    """The value as a place reads it that is only passed where it was set."""
    return value._replace(unset=False) if value.unset else value


def below(value: Value, limit: float, strictly: bool) -> Value:
    """Those that are at most ``limit``, or below it."""
    if value.wild:
        return value
    high = math.nextafter(limit, -math.inf) if strictly else limit
    if high >= value.high:
        return value
    if value.step and high >= value.low and abs(limit) < _VAST:
        last, first = math.floor(limit * UNITS), _base(value)
        last -= strictly and last == limit * UNITS
        high = (first + (last - first) // value.step * value.step) / UNITS
    return _kept(value, value.low, high)


def above(value: Value, limit: float, strictly: bool) -> Value:
    """Those that are at least ``limit``, or above it."""
    if value.wild:
        return value
    low = math.nextafter(limit, math.inf) if strictly else limit
    if low <= value.low:
        return value
    if value.step and low <= value.high and abs(limit) < _VAST:
        first, base = math.ceil(limit * UNITS), _base(value)
        first += strictly and first == limit * UNITS
        low = (base - (base - first) // value.step * value.step) / UNITS
    return _kept(value, low, value.high)


def without_zero(value: Value) -> Value:
    """Those that are not 0. What is not finite stays."""
    if not may_be_zero(value):
        return value
    if value.low == value.high:
        return NOTHING._replace(wild=value.wild, unset=value.unset)
    if value.step and value.low == 0:
        return _kept(value, value.low + value.step / UNITS, value.high)
    if value.step and value.high == 0:
        return _kept(value, value.low, value.high - value.step / UNITS)
    return value._replace(holed=True)


def only_zero(value: Value) -> Value:
    """What is left where a value is known to be 0."""
    return NO if may_be_zero(value) else NOTHING


def near(value: Value, other: Value, within: float) -> Value:
    """Those that are less than ``within``, which is below 1, away from one of the other's."""
    if value.wild or other.wild or other.empty:
        return value
    whole = value.whole and other.whole
    room = 0.0 if whole else within * (1 + 1e-9)
    return above(below(value, _outward(other.high + room), False), -_outward(room - other.low), False)


def apart(value: Value, other: Value, within: float) -> Value:
    """Those that are at least ``within`` away from the other, if it is one number."""
    if value.wild or not other.exact:
        return value
    middle = other.low
    found = without_zero(value) if middle == 0 else value
    room = within * (1 - 1e-9)
    if found.low > middle - room:
        found = above(found, middle + room, False)
    if found.high < middle + room:
        found = below(found, middle - room, False)
    return found


def moved(value: Value, other: Value, low: float, high: float) -> Value:
    """The range of a sum or difference, on the grid that both share."""
    is_far = low < -LARGEST or high > LARGEST
    if is_far:
        return between(low, high, 0, value.whole and other.whole)
    return between(low, high, math.gcd(value.step, other.step) if _has_grid(value) and _has_grid(other) else 0)


def _held(low: float, high: float, step: int, whole: bool) -> int:
    """The grid that a range of these bounds can have."""
    if low >= high:
        return 0
    return step if low >= -LARGEST and high <= LARGEST else UNITS if whole else 0


def _outward(number: float) -> float:
    return math.nextafter(number, math.inf)


def _kept(value: Value, low: float, high: float) -> Value:
    if low > high or (value.holed and low == high == 0):
        return NOTHING._replace(wild=value.wild, unset=value.unset)
    step = value.step if low < high else 0
    return Value(low, high, step, value.holed, value.wild, value.unset, value.texts)


def _rest(low: float, value: Value) -> float:
    """The next resting place at or below a bound that moves down; for one that moves up, its negative is asked for."""
    if low >= 0 and not value.step:
        return 0.0
    for place in (LARGEST / 2, LARGEST):
        # From the first place a step or two more still lie on the grid.
        if low >= -place:
            base = _units(low)
            return (base - (base + int(place) * UNITS) // value.step * value.step) / UNITS if value.step else -place
    return -math.inf


def _grid(value: Value) -> tuple[int, int] | None:
    """A number of the grid and the distance, in units; the distance of a single number is 0. None: there is no grid."""
    return (_base(value), value.step) if _has_grid(value) else None


def _has_grid(value: Value) -> bool:
    if value.low == value.high:
        return value.step != 0 or _on_grid(value.low)
    return value.step != 0 and value.low < value.high


def _common(one: Value, two: Value) -> int:
    """The step of the grid that holds both; 0 if there is none."""
    a, b = _grid(one), _grid(two)
    return 0 if a is None or b is None else math.gcd(a[1], b[1], a[0] - b[0])


def _on_grid(number: float) -> bool:
    return number.is_integer() or (abs(number) <= LARGEST and (number * UNITS).is_integer())


def _base(value: Value) -> int:
    """A number of a value's grid, in units."""
    bound = value.low if math.isfinite(value.low) else value.high
    return _units(bound) if math.isfinite(bound) else 0


def _units(number: float) -> int:
    return int(number * UNITS) if -_VAST < number < _VAST else int(number) * UNITS
