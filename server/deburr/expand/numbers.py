"""How computed values are written in flat programs: decimal notation, no exponent, half away from zero, no trailing zeros. Never reads a program."""

from decimal import MAX_EMAX, MIN_EMIN, ROUND_HALF_UP, Context, Decimal

from deburr.expand.job import EXACT

_WIDE = Context(prec=800, Emax=MAX_EMAX, Emin=MIN_EMIN)


def written(value: float, decimals: int = EXACT, minus_zero: bool = False) -> str:
    """The shortest decimal text that reads back as the value, with at most so many decimals. ``minus_zero``: whether -0 keeps its sign."""
    text = repr(value)
    whole, _, fraction = text.partition(".")
    if "e" in fraction or "e" in whole or len(fraction) > decimals:
        return _rounded(Decimal(text), decimals, minus_zero)
    if fraction == "0":
        return "0" if whole == "-0" and not minus_zero else whole
    return f"{whole}.{fraction}" if fraction else whole


def written_decimal(value: Decimal, decimals: int) -> str:
    """The same of an exact number."""
    return _rounded(value, decimals, False)


def _rounded(value: Decimal, decimals: int, minus_zero: bool) -> str:
    exponent = value.as_tuple().exponent
    if isinstance(exponent, int) and -exponent > decimals:
        value = value.quantize(Decimal(1).scaleb(-decimals), ROUND_HALF_UP, _WIDE)
    text = format(value, "f")
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") and not minus_zero else text
