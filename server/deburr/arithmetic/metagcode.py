"""MetaGCODE's arithmetic on exact decimals: comparison, the passes of a loop, and how its values are printed (spec/metagcode.md §5.3 to §5.5)."""

import operator
import re
from collections.abc import Callable, Mapping
from decimal import Decimal
from typing import Any

from deburr_grammar.dialects.metagcode.forms import number

DECIMALS = 4
"""Decimals of printed values, unless another number of them is asked for."""
MOST_DECIMALS = 6

COMPARISONS: Mapping[str, Callable[[Any, Any], bool]] = {
    "greaterthan": operator.gt,
    "lessthan": operator.lt,
    "equalto": operator.eq,
    "notequalto": operator.ne,
}
"""The operators of a condition in small letters, on two numbers or on two texts, which are ordered by code points."""

_LED = re.compile(r"[+-]?[0-9]*[.,]?[0-9]+(?=[A-Za-z\"']*$)")
_POWER = re.compile(r"[+-]?[0-9]+(?:\.[0-9]*)?[eE][+-]?[0-9]{1,2}")
_SHORT = 10_000
"""Bits up to which Python writes an integer at once; longer ones take the way by a decimal, which knows no limit."""


def number_meant(said: str) -> str:
    """The end of a message on a text that is no number: the number that is meant, as it should be written, or nothing."""
    if _POWER.fullmatch(said):
        return f"; there is no exponent, write `{Decimal(said):f}`"
    led = _LED.match(said)
    meant = led[0].replace(",", ".") if led else ""
    return f"; did you mean `{meant}`?" if number(meant) is not None else ""


def passes(total: Decimal, step: Decimal) -> int:
    """How often a loop goes round for one of its variables: the quotient of magnitudes, raised to the next integer. The step is not 0."""
    a, b = total.as_integer_ratio()
    c, d = step.as_integer_ratio()
    return -(-abs(a * d) // abs(b * c))


class Counted:
    """What a loop variable is in each pass, as it is printed.

    Cumulative values are total * pass / passes, rounded half away from 0; relative ones are the
    differences between those, so that they always add up to the printed total.
    """

    def __init__(self, total: Decimal, count: int, decimals: int, relative: bool) -> None:
        numerator, denominator = total.as_integer_ratio()
        self._step: int = 2 * numerator * 10**decimals
        self._parts = denominator * count
        self._decimals = decimals
        self._relative = relative

    def printed(self, number: int) -> str:
        """The text in a pass, counted from 1."""
        value = self._rounded(number)
        return _written(value - self._rounded(number - 1) if self._relative else value, self._decimals)

    def _rounded(self, number: int) -> int:
        """The cumulative value in units of the last decimal."""
        doubled = self._step * number
        magnitude = (abs(doubled) + self._parts) // (2 * self._parts)
        return -magnitude if doubled < 0 else magnitude


def _written(value: int, decimals: int) -> str:
    """An integer of units of the last decimal: no exponent, no trailing zeros, never -0."""
    sign = "-" if value < 0 else ""
    magnitude = abs(value)
    digits = str(magnitude) if magnitude.bit_length() < _SHORT else str(Decimal(magnitude))
    if not decimals:
        return sign + digits
    digits = digits.rjust(decimals + 1, "0")
    return (sign + digits[:-decimals] + "." + digits[-decimals:]).rstrip("0").rstrip(".")
