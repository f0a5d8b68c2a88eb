"""Numbers as a code generator prints them: formats of digits, point and sign (spec/cgt.md §5.1, §11). Knows no word."""

from __future__ import annotations

from typing import NamedTuple

from deburr.arithmetic.cgt import rounded
from deburr.expand.numbers import written
from deburr.formats.machine import FORMAT

MOST_DIGITS = 400
"""Digits that a format may ask for on each side of the point, and characters of a width: no number has more."""
FREE_DECIMALS = 4
"""Decimals of `#V` and `#U` words that have no format of their own."""


class Digits(NamedTuple):
    """A rounded number: whether it is below 0, its digits before the point without leading zeros, and all that the format has behind it."""

    negative: bool
    whole: str
    fraction: str


class Format(NamedTuple):
    """A number format: its type, its sign, how many digits stand before and behind the point, and how wide the text is at least."""

    type: str
    sign: str
    before: int
    behind: int
    width: int = 0

    def quick(self, value: float) -> str | None:
        """What is printed, where that is the number's shortest text: most coordinates. None: it must be made from digits."""
        if self.type != "D" or self.sign or self.width or not value:
            return None
        text = repr(value)
        whole, _, fraction = text.partition(".")
        fits = fraction and len(fraction) <= self.behind and len(whole) - (value < 0) <= self.before
        return text if fits and "e" not in fraction else None

    def digits(self, value: float) -> Digits:
        """A number as far as the format prints it: rounded half away from 0, no minus before a zero."""
        whole, _, fraction = repr(abs(value)).partition(".")
        fraction = fraction if fraction != "0" else ""
        if "e" in whole or "e" in fraction or len(fraction) > self.behind:
            whole, _, fraction = format(rounded(abs(value), self.behind), "f").partition(".")
        whole, fraction = whole.lstrip("0"), fraction.ljust(self.behind, "0")
        return Digits(value < 0 and bool(whole or fraction.strip("0")), whole, fraction)

    def text(self, digits: Digits) -> str:
        """What is printed. Digits that are too many for the format are not cut off."""
        negative, whole, fraction = digits
        minus = negative and self.sign != "!"
        sign = "-" if minus else "+" if self.sign == "+" else ""
        return (sign + self._unsigned(whole, fraction)).rjust(self.width)

    def _unsigned(self, whole: str, fraction: str) -> str:
        match self.type:
            case "D":
                return f"{whole or '0'}.{fraction.rstrip('0') or fraction[:1]}"
            case "F":
                return whole.rjust(self.before, "0") + fraction or "0"
            case "T":
                return (whole + fraction).lstrip("0") or "0"
            case "L":
                return (whole.rjust(self.before, "0") + fraction).rstrip("0") or "0"
            case "Z":
                short = fraction.rstrip("0")
                return f"{whole}.{short}" if whole or short else "0"
            case _:
                filled = whole.rjust(self.before, "0") if self.type == "E" else whole
                return f"{filled or ('' if fraction else '0')}.{fraction}"


def format_of(said: str, width: str = "") -> Format | None:
    """A format such as `D+3.4` with its width; None if there is no such format."""
    if not FORMAT.fullmatch(said) or (width and not (width.isascii() and width.isdigit())):
        return None
    sign = said[1] if said[1] in "+!" else ""
    counts = [*said[1 + len(sign) :].split("."), width or "0"]
    if max(map(len, counts)) > len(str(MOST_DIGITS)) or max(map(int, counts)) > MOST_DIGITS:
        return None
    before, behind, wide = map(int, counts)
    return Format(said[0], sign, before, behind, wide)


def free(value: float) -> str:
    """A number as `#V` and `#U` words print it: up to 4 decimals, no trailing zeros, as many digits as it has."""
    return written(value, FREE_DECIMALS)
