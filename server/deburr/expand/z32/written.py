"""How computed values are written: at most nine significant digits, because the control takes no more (spec/z32.md §2, §6.7, §11)."""

from decimal import Decimal

from deburr.expand.numbers import written_decimal

DECIMALS = 6
DIGITS = 9


def written(value: float, decimals: int = DECIMALS) -> str | None:
    """A value in decimal notation; None if its integer part has more digits. What is rounded is the shortest text of the double."""
    text = repr(value)
    whole, _, fraction = text.partition(".")
    if "e" not in text and len(whole) + len(fraction) <= DIGITS and len(fraction) <= decimals:
        if fraction != "0":
            return text
        return "0" if whole == "-0" else whole
    exact = Decimal(text)
    if not exact:
        return "0"
    room = DIGITS - 1 - exact.adjusted()
    if room < 0:
        return None
    found = written_decimal(exact, min(decimals, room))
    digits = found.lstrip("-0").replace(".", "").lstrip("0")
    return found if len(digits) <= DIGITS else None
