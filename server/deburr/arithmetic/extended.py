"""Sine, cosine and tangent of degrees as the RS274 control calculates them: in numbers of 64 significant bits, rounded to doubles at the end.

The control multiplies by its 64-bit pi, divides by 180 and takes the function of that; so
`SIN[180]` is -5e-20 and `FIX[SIN[30]*10]` is 5 (spec/oracle.md §3). Integers do it exactly here.
"""

from __future__ import annotations

import math
from functools import cache, lru_cache
from typing import NamedTuple

_BITS = 64
_SPARE = 192
_PI = 0xC90FDAA22168C235
"""The control's pi: 64 bits, the first two before the point."""


class Extended(NamedTuple):
    """``mantissa`` times two to the ``exponent``; the mantissa has 64 bits or is 0."""

    mantissa: int
    exponent: int

    def double(self) -> float:
        """The nearest double."""
        return math.ldexp(float(self.mantissa), self.exponent)


@lru_cache(4096)
def sine(degrees: float) -> float:
    """SIN."""
    return _function(degrees, 0)


@lru_cache(4096)
def cosine(degrees: float) -> float:
    """COS."""
    return _function(degrees, 1)


@lru_cache(4096)
def tangent(degrees: float) -> float:
    """TAN."""
    if degrees == 0:
        return degrees
    sin, cos, bits = _sine_cosine(_radians(degrees))
    return _rounded(sin << bits, cos, -bits).double() if cos else math.inf


def degrees(radians: float) -> float:
    """What the control makes of an arc function's result: times 180 as a double, divided by its pi."""
    product = radians * 180.0
    mantissa, exponent = _parts(product)
    return _rounded(mantissa, _PI, exponent + 62).double()


def _function(degrees: float, which: int) -> float:
    if degrees == 0:
        return (degrees, 1.0)[which]
    found = _sine_cosine(_radians(degrees))
    return _rounded(found[which], 1, -found[2]).double()


def _radians(degrees: float) -> Extended:
    """Times pi, rounded to 64 bits, divided by 180, rounded to 64 bits."""
    mantissa, exponent = _parts(degrees)
    product = _rounded(mantissa * _PI, 1, exponent - 62)
    return _rounded(product.mantissa, 180, product.exponent)


def _parts(value: float) -> tuple[int, int]:
    """A double as a whole number times a power of two."""
    numerator, denominator = value.as_integer_ratio()
    return numerator, 1 - denominator.bit_length()


def _rounded(numerator: int, denominator: int, exponent: int) -> Extended:
    """A quotient times a power of two with 64 bits, half to even."""
    if not numerator:
        return Extended(0, 0)
    sign = -1 if (numerator < 0) != (denominator < 0) else 1
    numerator, denominator = abs(numerator), abs(denominator)
    shift = _BITS - (numerator.bit_length() - denominator.bit_length())
    while True:
        quotient, rest = divmod(numerator << max(shift, 0), denominator << max(-shift, 0))
        if quotient.bit_length() <= _BITS:
            break
        shift -= 1
    double_rest, whole = 2 * rest, denominator << max(-shift, 0)
    if double_rest > whole or (double_rest == whole and quotient & 1):
        quotient += 1
    return Extended(sign * quotient, exponent - shift)


def _sine_cosine(angle: Extended) -> tuple[int, int, int]:
    """Sine and cosine as whole numbers, and how many of their bits stand behind the point."""
    size = abs(angle.mantissa).bit_length() + angle.exponent
    # Enough bits before the point for the turns, enough behind it for a small angle or a small rest.
    bits = 64 * (-(-(_SPARE + abs(size)) // 64))
    quarter = _quarter_turn(bits)
    shift = bits + angle.exponent
    value = angle.mantissa << shift if shift >= 0 else angle.mantissa >> -shift
    turns = (2 * value + quarter) // (2 * quarter)
    sin, cos = _series(value - turns * quarter, bits)
    for _ in range(turns % 4):
        sin, cos = cos, -sin
    return sin, cos, bits


def _series(angle: int, bits: int) -> tuple[int, int]:
    """Taylor's sums of a small angle."""
    one = 1 << bits
    sums = [0, 0]
    term, number = one, 0
    while term:
        sums[number % 2] += -term if number % 4 > 1 else term
        number += 1
        # Towards zero, so that the terms die out.
        product = abs(term * angle) // number >> bits
        term = product if (term < 0) == (angle < 0) else -product
    return sums[1], sums[0]


@cache
def _quarter_turn(bits: int) -> int:
    """Half of pi (Machin)."""
    spare = 32
    one = 1 << (bits + spare)
    pi = 4 * (4 * _arc_tangent_of_inverse(5, one) - _arc_tangent_of_inverse(239, one))
    return pi >> (spare + 1)


def _arc_tangent_of_inverse(number: int, one: int) -> int:
    power = total = one // number
    odd, sign = 1, 1
    while power:
        power //= number * number
        odd, sign = odd + 2, -sign
        total += sign * (power // odd)
    return total
