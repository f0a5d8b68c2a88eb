"""CGT's operators and functions on ranges: what is exact is calculated by `arithmetic/cgt` alone (spec/cgt.md §5.8, §11). Knows no words."""

from __future__ import annotations

import math
from collections.abc import Callable

from deburr.arithmetic import Refusal
from deburr.arithmetic.cgt import function, operation
from deburr.values import operations as on
from deburr.values.domain import ANY, LARGEST, UNITS, Value, between, may_be_zero


def _raised(a: float, b: float) -> float:
    """A power of bounds; one that is too large has none."""
    try:
        return math.pow(a, b)
    except OverflowError:
        return math.inf


def _power(a: Value, b: Value) -> Value:
    if a.high < 0 and b.exact and b.low % 1 != 0:
        _POWER(a.high, b.low)
    return on.power(_raised)(a, b)


def _remainder(a: Value, b: Value) -> Value:
    """A rest with the sign of the dividend; only whole parts are divided."""
    if b.low > -1 and b.high < 1:
        _apply("MOD")(1.0, 0.0)
    most = max(map(_whole, (-b.low, b.high))) - 1
    low, high = max(-most, -max(0.0, _whole(-a.low))), min(most, max(0.0, _whole(a.high)))
    return Value(low + 0.0, high + 0.0, UNITS if low < high else 0, wild=b.low < 1 and b.high > -1)


def _whole(number: float) -> float:
    return number if math.isinf(number) else float(math.trunc(number))


def _greatest(a: Value, b: Value) -> Value:
    if a.low >= b.high or b.low >= a.high:
        return a if a.low >= b.high else b
    return _chosen(max(a.low, b.low), max(a.high, b.high), a, b)


def _least(a: Value, b: Value) -> Value:
    if a.high <= b.low or b.high <= a.low:
        return a if a.high <= b.low else b
    return _chosen(min(a.low, b.low), min(a.high, b.high), a, b)


def _chosen(low: float, high: float, a: Value, b: Value) -> Value:
    whole = a.whole and b.whole and low < high
    return Value(low, high, UNITS if whole else 0, not (may_be_zero(a) or may_be_zero(b)))


def _rounded(a: Value, places: Value) -> Value:
    """Rounding to a known number of places never turns an order around."""
    if not places.exact:
        return ANY
    low, high = (_bound(bound, places.low) for bound in (a.low, a.high))
    return between(low, high, UNITS if places.low < 1 and low < high else 0)


def _bound(number: float, places: float) -> float:
    try:
        return _apply("RND")(number, places) if math.isfinite(number) else number
    except Refusal:
        return math.copysign(math.inf, number)


def _sign(a: Value) -> Value:
    low, high = _apply("SGN")(a.low), _apply("SGN")(a.high)
    step = 0 if low == high else UNITS if may_be_zero(a) or low + high else 2 * UNITS
    return Value(low, high, step)


def _apply(name: str) -> Callable[..., float]:
    found = function(name)
    assert found is not None
    return found.apply


_POWER = operation("^")
OPERATORS = {
    sign: on.lifted(operation(sign), ranges)
    for sign, ranges in {
        "+": on.plus,
        "-": on.minus,
        "*": on.times,
        "/": on.divided(operation("/")),
        "^": _power,
    }.items()
}
"""The operators. What may be no finite number is wild: the control stops there."""
_ONE = {
    "ABS": on.magnitude,
    "ACOS": on.falling(_apply("ACOS"), -1.0, 1.0),
    "ASIN": on.rising(_apply("ASIN"), -1.0, 1.0),
    "ATAN": on.within(-90.0, 90.0),
    "CEIL": on.rounded(_apply("CEIL")),
    "COS": on.within(-1.0, 1.0),
    "DMS": on.within(-math.inf, math.inf),
    "FLOOR": on.rounded(_apply("FLOOR")),
    "INT": on.rounded(_apply("INT")),
    "SGN": _sign,
    "SIN": on.within(-1.0, 1.0),
    "SQR": on.rising(_apply("SQR"), 0.0, math.inf, 0.0),
    "TAN": on.within(-math.inf, math.inf),
}
_TWO = {"MAX": _greatest, "MIN": _least, "MOD": _remainder, "RND": _rounded}
FUNCTIONS: dict[str, on.Lifted] = {
    **{name: on.lifted(_apply(name), ranges, 1) for name, ranges in _ONE.items()},
    **{name: on.lifted(_apply(name), ranges) for name, ranges in _TWO.items()},
    "PI": lambda: Value(math.pi, math.pi),
    "TOTEL": lambda: Value(0.0, LARGEST, UNITS, wild=True),
}
"""The functions of numbers."""
