"""RS274's operators and functions (spec/rs274.md §3), and what literal values come to. A value that only the run knows is None."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

from deburr.arithmetic import ArithmeticFault, Refusal, extended, tried
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
        case "group":
            return tried(finite, part, part, constant(text, part.children[1], settings))
        case "label":
            return constant(text, part.children[0], settings)
        case "signed":
            inner = constant(text, part.children[1], settings)
            return -inner if isinstance(inner, float) and text[part.start] == "-" else inner
        case "function":
            name, value = spelled(text, part.children[0]), constant(text, part.children[1], settings)
            return tried(function(name), part, part, value)
        case "atan":
            y, x = (constant(text, part.children[at], settings) for at in (1, 3))
            return tried(atan, part, part, y, x)
        case "sum" | "product" | "quotient" | "modulo" | "power" | "comparison" | "logical":
            return _operation(text, part, settings)
        case _:
            return None


def operation(sign: str, near: float) -> Callable[[float, float], float]:
    """A binary operator; it raises `Refusal` where the control refuses. ``near``: how near two values are that are EQ."""
    return _OPERATORS[sign] if sign not in _COMPARED else _COMPARED[sign](near)


def function(name: str) -> Callable[[float], float]:
    """A function of one value; it raises `Refusal` where the control refuses."""
    return _FUNCTIONS[name]


def atan(y: float, x: float) -> float:
    """ATAN[y]/[x]: the angle of a direction in degrees, over -180 up to 180."""
    return extended.degrees(math.atan2(y, x))


def spelled(text: str, part: Node | Token) -> str:
    """An operator's or a function's canonical spelling."""
    return canonical(text[part.start : part.end])


@lru_cache(maxsize=256)
def canonical(said: str) -> str:
    """The same of one that is cut out."""
    return "".join(said.split()).upper()


def _operation(text: str, part: Node, settings: Mapping[str, Any]) -> Value:
    left, sign, right = part.children
    found = operation(spelled(text, sign), TOLERANCE[settings["compare"]])
    a, b = constant(text, left, settings), constant(text, right, settings)
    if a is None and b == 0 and found is _divided:
        # Only a divisor decides alone: whatever is divided, the control refuses a zero.
        a = 1.0
    return tried(lambda *values: found(*values), part, right, a, b)


def finite(value: float) -> float:
    """What brackets give: only there does the control look whether a result is a number. Between operators it goes on with an infinite one."""
    if value - value != 0:
        raise Refusal("not-finite", "a result that is no finite number")
    return value


def _divided(a: float, b: float) -> float:
    if b == 0:
        raise Refusal("divide-by-zero", "a division by zero")
    return a / b


def _modulo(a: float, b: float) -> float:
    """Never negative, whatever the signs."""
    if b == 0 or math.isinf(a):
        return math.nan
    rest = math.fmod(a, b)
    return rest + abs(b) if rest < 0 else rest


def _power(a: float, b: float) -> float:
    if a < 0 and b % 1 != 0:
        raise Refusal("domain", "a negative number raised to a power that is no integer")
    try:
        return math.pow(a, b)
    except (OverflowError, ValueError):
        # No power of a double but one that is too large, and no negative power but of zero, comes here.
        return -math.inf if (a < 0 or math.copysign(1, a) < 0) and b % 2 == 1 else math.inf


def _tolerant(exact: Callable[[float, float], bool]) -> Callable[[float], Callable[[float, float], float]]:
    """GE and LE: newer controls take near values for equal."""

    def of(near: float) -> Callable[[float, float], float]:
        if near < TOLERANCE["1e-4"]:
            return lambda a, b: 1.0 if exact(a, b) or abs(a - b) < near else 0.0
        return lambda a, b: 1.0 if exact(a, b) else 0.0

    return of


_COMPARED: dict[str, Callable[[float], Callable[[float, float], float]]] = {
    "EQ": lambda near: lambda a, b: 1.0 if abs(a - b) < near else 0.0,
    "NE": lambda near: lambda a, b: 1.0 if abs(a - b) >= near else 0.0,
    "GE": _tolerant(lambda a, b: a >= b),
    "LE": _tolerant(lambda a, b: a <= b),
}
_OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": _divided,
    "MOD": _modulo,
    "**": _power,
    "GT": lambda a, b: 1.0 if a > b else 0.0,
    "LT": lambda a, b: 1.0 if a < b else 0.0,
    "AND": lambda a, b: 1.0 if a and b else 0.0,
    "OR": lambda a, b: 1.0 if a or b else 0.0,
    "XOR": lambda a, b: 1.0 if bool(a) != bool(b) else 0.0,
}


def _within(refuses: Callable[[float], bool], why: str, function: Callable[[float], float]) -> Callable[[float], float]:
    def applied(a: float) -> float:
        if refuses(a):
            raise Refusal("domain", why)
        return function(a)

    return applied


def _exponential(a: float) -> float:
    try:
        return math.exp(a)
    except OverflowError:
        raise Refusal("not-finite", "a result that is no finite number") from None


def _half_away(a: float) -> float:
    return float(math.floor(a + 0.5) if a >= 0 else -math.floor(-a + 0.5))


_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "ABS": abs,
    "ACOS": _within(lambda a: abs(a) > 1, "ACOS of a number outside -1 to 1", lambda a: extended.degrees(math.acos(a))),
    "ASIN": _within(lambda a: abs(a) > 1, "ASIN of a number outside -1 to 1", lambda a: extended.degrees(math.asin(a))),
    "COS": extended.cosine,
    "EXP": _exponential,
    "FIX": lambda a: float(math.floor(a)),
    "FUP": lambda a: float(math.ceil(a)),
    "LN": _within(lambda a: a <= 0, "LN of a number that is not above 0", math.log),
    "ROUND": _half_away,
    "SIN": extended.sine,
    "SQRT": _within(lambda a: a < 0, "the square root of a negative number", math.sqrt),
    "TAN": extended.tangent,
}
