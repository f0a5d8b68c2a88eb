"""RS274's arithmetic on literal values (spec/rs274.md §3). A value that only the run knows is None."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from deburr.arithmetic import ArithmeticFault
from deburr_grammar.tree import Node, Token

Value = float | ArithmeticFault | None
TOLERANCE = {"1e-4": 1e-4, "1e-6": 1e-6}


def number(text: str) -> float:
    """A written number; blanks may stand anywhere in it (spec/rs274.md §1.2)."""
    return float("".join(text.split()))


def constant(text: str, part: Node | Token, settings: Mapping[str, Any]) -> Value:
    """The value of a part of a line if it follows from the line alone; a fault if the control refuses to calculate it."""
    if isinstance(part, Token):
        return number(text[part.start : part.end]) if part.kind == "NUMBER" else None
    match part.kind:
        case "group" | "label":
            return constant(text, part.children[1 if len(part.children) > 1 else 0], settings)
        case "signed":
            inner = constant(text, part.children[1], settings)
            return -inner if isinstance(inner, float) and text[part.start] == "-" else inner
        case "function":
            return _function(text, part, settings)
        case "atan":
            return _two(text, part.children[1], part.children[3], settings, _atan)
        case "sum" | "product" | "quotient" | "modulo" | "power" | "comparison" | "logical":
            return _operation(text, part, settings)
        case _:
            return None


def _operation(text: str, part: Node, settings: Mapping[str, Any]) -> Value:
    left, sign, right = part.children
    operator = "".join(text[sign.start : sign.end].split()).upper()

    def apply(a: float, b: float) -> Value:
        if operator == "/" and b == 0:
            return ArithmeticFault("divide-by-zero", right, "a division by zero")
        if operator == "**" and a < 0 and b != math.floor(b):
            return ArithmeticFault("domain", part, "a negative number raised to a power that is no integer")
        return _finite(lambda: _OPERATORS[operator](a, b, TOLERANCE[settings["compare"]]), part)

    return _two(text, left, right, settings, apply)


def _two(
    text: str,
    left: Node | Token,
    right: Node | Token,
    settings: Mapping[str, Any],
    apply: Callable[[float, float], Value],
) -> Value:
    a, b = constant(text, left, settings), constant(text, right, settings)
    for value in (a, b):
        if isinstance(value, ArithmeticFault):
            return value
    if a is None and isinstance(b, float) and apply is not _atan:
        # Only a divisor decides alone: whatever is divided, the control refuses a zero.
        fault = apply(1.0, b)
        return fault if isinstance(fault, ArithmeticFault) and fault.rule == "divide-by-zero" else None
    return apply(a, b) if isinstance(a, float) and isinstance(b, float) else None


def _function(text: str, part: Node, settings: Mapping[str, Any]) -> Value:
    name = "".join(text[part.children[0].start : part.children[0].end].split()).upper()
    value = constant(text, part.children[1], settings)
    if not isinstance(value, float):
        return value
    refuses, why = _DOMAINS.get(name, (None, ""))
    if refuses is not None and refuses(value):
        return ArithmeticFault("domain", part, why)
    calculate = _FUNCTIONS.get(name)
    return _finite(lambda: calculate(value), part) if calculate is not None else None


def _finite(calculate: Callable[[], float], part: Node) -> Value:
    try:
        value = calculate()
    except (OverflowError, ValueError, ZeroDivisionError):
        value = math.inf
    return value if math.isfinite(value) else ArithmeticFault("not-finite", part, "a result that is no finite number")


def _atan(y: float, x: float) -> float:
    return math.atan2(y, x) * 180.0 / math.pi


def _modulo(a: float, b: float) -> float:
    """Never negative, whatever the signs."""
    if b == 0:
        return math.nan
    rest = math.fmod(a, b)
    return rest + abs(b) if rest < 0 else rest


_OPERATORS: dict[str, Callable[[float, float, float], float]] = {
    "+": lambda a, b, _: a + b,
    "-": lambda a, b, _: a - b,
    "*": lambda a, b, _: a * b,
    "/": lambda a, b, _: a / b,
    "MOD": lambda a, b, _: _modulo(a, b),
    "**": lambda a, b, _: math.pow(a, b),
    "EQ": lambda a, b, near: float(abs(a - b) < near),
    "NE": lambda a, b, near: float(abs(a - b) >= near),
    "GT": lambda a, b, _: float(a > b),
    "LT": lambda a, b, _: float(a < b),
    "GE": lambda a, b, near: float(a >= b or near < 1e-4 and abs(a - b) < near),
    "LE": lambda a, b, near: float(a <= b or near < 1e-4 and abs(a - b) < near),
    "AND": lambda a, b, _: float(bool(a) and bool(b)),
    "OR": lambda a, b, _: float(bool(a) or bool(b)),
    "XOR": lambda a, b, _: float(bool(a) != bool(b)),
}
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "ABS": abs,
    "ACOS": lambda a: math.acos(a) * 180.0 / math.pi,
    "ASIN": lambda a: math.asin(a) * 180.0 / math.pi,
    "EXP": math.exp,
    "FIX": lambda a: float(math.floor(a)),
    "FUP": lambda a: float(math.ceil(a)),
    "LN": math.log,
    "ROUND": lambda a: float(math.floor(a + 0.5) if a >= 0 else -math.floor(-a + 0.5)),
    "SQRT": math.sqrt,
}
"""SIN, COS and TAN are missing on purpose: the control calculates them in 80-bit numbers, so no double is their value."""
_DOMAINS: dict[str, tuple[Callable[[float], bool], str]] = {
    "ACOS": (lambda a: abs(a) > 1, "ACOS of a number outside -1 to 1"),
    "ASIN": (lambda a: abs(a) > 1, "ASIN of a number outside -1 to 1"),
    "LN": (lambda a: a <= 0, "LN of a number that is not above 0"),
    "SQRT": (lambda a: a < 0, "the square root of a negative number"),
}
