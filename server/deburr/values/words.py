"""Values in people's words. Knows no language but how its numbers are written."""

from __future__ import annotations

import math

from deburr.values.domain import LARGEST, UNITS, Value


def said(value: Value) -> str:
    """A value: `5`, `0 … 90 step 10`, `at least 3`, `"G00" or "G01"`; empty if there is nothing to say."""
    if value.texts:
        return " or ".join(f'"{text}"' for text in sorted(value.texts))
    if value.empty:
        return "not set" if value.unset else ""
    text = _range(value)
    if value.holed and text and value.low < 0 < value.high:
        text += ", never 0"
    elif value.holed and not text:
        text = "never 0"
    return f"{text}, or not set" if value.unset and text else text


def _range(value: Value) -> str:
    low, high = value.low > -LARGEST / 4, value.high < LARGEST / 4
    if value.low == value.high:
        return _number(value.low)
    integers = value.step == UNITS and value.whole
    step = f" step {_number(value.step / UNITS)}" if value.step and not integers else ""
    if low and high:
        return f"{_number(value.low)} … {_number(value.high)}{step}" + (", integers" if integers else "")
    if low:
        return f"{_strict(value.low, math.inf, 'above', 'at least')}{step}"
    return _strict(value.high, -math.inf, "below", "at most") if high else ""


def _strict(number: float, away: float, beyond: str, from_here: str) -> str:
    """A bound that is the neighbour of a number which is easier to say."""
    near = math.nextafter(number, -away)
    return f"{beyond} {_number(near)}" if len(repr(near)) < len(repr(number)) - 2 else f"{from_here} {_number(number)}"


def _number(number: float) -> str:
    return f"{number + 0.0:.10g}"
