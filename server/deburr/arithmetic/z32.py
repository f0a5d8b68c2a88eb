"""Z32's arithmetic on IEEE doubles (spec/z32.md §4, §11): operators, functions, rounding, comparison, polar conversion."""

import math
import sys
from collections.abc import Callable, Mapping, Sequence
from decimal import ROUND_HALF_UP, Decimal

from deburr.arithmetic import ArithmeticFault, Refusal
from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.tree import Node, Token

Value = float | ArithmeticFault | None
"""A number; a fault; or None for what only the run knows."""
Read = Callable[[Node | Token], Value]
"""The value of a parameter: a name token, or an `other`, `alias_name` or `vector` node."""

CLOSE = 1e-9
"""How far apart, relative to the larger, two equal values may be: the control keeps nine digits."""
NEAR_INTEGER = 1e-6
"""How far from an integer an index or a program number may be."""


def operation(sign: str) -> Callable[[float, float], float]:
    """What `+`, `-`, `*` or `/` does with two numbers; what the control refuses is a `Refusal`."""
    return _OPERATIONS[sign]


def function(name: str) -> Callable[[float], float]:
    """The function of that name, in upper case; what the control refuses is a `Refusal`."""
    return _FUNCTIONS[name]


def constant(text: str, part: Node | Token) -> Value:
    """The value of an expression if it follows from the line alone; a fault if the control refuses to calculate it."""
    return evaluate(text, part, lambda _: None)


def evaluate(text: str, part: Node | Token, read: Read) -> Value:
    """The value of a part of a line: a number, an expression or a value with its sign. Parameters are asked of ``read``."""
    if isinstance(part, Token):
        if part.kind == "NUMBER":
            written = number(text[part.start : part.end])
            return written if math.isfinite(written) else None
        return math.pi if part.kind == "PI" else read(part)
    match part.kind:
        case "angle" | "group":
            return evaluate(text, part.children[1], read)
        case "signed" | "unary":
            value = evaluate(text, part.children[1], read)
            return -value if isinstance(value, float) and text[part.start] == "-" else value
        case "sum" | "product":
            return _chain(text, part, read)
        case "function":
            return _function(text, part, read)
        case "bad_number" | "loose" | "reserved":
            return None
        case _:
            return read(part)


def nearest(value: float) -> float:
    """The nearest integer, halves away from 0. Rounded is the shortest decimal text of the double, which is what a person sees."""
    return float(Decimal(repr(value)).to_integral_value(ROUND_HALF_UP))


def shown(value: float) -> str:
    """A value as a person writes it."""
    return f"{value:.9g}"


def integer(value: float) -> int | None:
    """The integer that a value stands for as an index or a program number; None if it is none."""
    whole = round(value)
    return whole if abs(value - whole) <= NEAR_INTEGER else None


def equal(a: float, b: float) -> bool:
    """`=` on reals."""
    return abs(a - b) <= CLOSE * max(1.0, abs(a), abs(b))


COMPARISONS: Mapping[str, Callable[[float, float], bool]] = {
    "=": equal,
    "<>": lambda a, b: not equal(a, b),
    "<": lambda a, b: a < b and not equal(a, b),
    ">": lambda a, b: a > b and not equal(a, b),
    "<=": lambda a, b: a < b or equal(a, b),
    ">=": lambda a, b: a > b or equal(a, b),
}
"""The relations of a condition, written without blanks and entities."""


def to_polar(x: float, y: float) -> tuple[float, float]:
    """CP: radius, and angle in degrees in (-180, 180]; the angle of the origin is 0."""
    angle = math.degrees(math.atan2(y, x))
    return math.hypot(x, y), 180.0 if angle == -180.0 else angle


def to_cartesian(radius: float, angle: float) -> tuple[float, float]:
    """PC: x and y of a radius and an angle in degrees."""
    return radius * cosine(angle), radius * sine(angle)


def sine(degrees: float) -> float:
    """SN: exact at multiples of 30 and 45 degrees."""
    turn = math.fmod(degrees, 360.0)
    exact = _SINES.get(abs(turn))
    return math.sin(math.radians(turn)) if exact is None else exact if turn >= 0 else 0.0 - exact


def cosine(degrees: float) -> float:
    """CS: exact at multiples of 30 and 45 degrees."""
    turn = abs(math.fmod(degrees, 360.0))
    exact = _SINES.get(math.fmod(turn + 90.0, 360.0)) if turn in _SINES else None
    return math.cos(math.radians(turn)) if exact is None else exact


def tangent(degrees: float) -> float | None:
    """TAN: exact at multiples of 30 and 45 degrees; None at odd multiples of 90, where there is none."""
    turn = math.fmod(degrees, 180.0)
    if abs(turn) == 90.0:
        return None
    exact = _TANGENTS.get(abs(turn))
    return math.tan(math.radians(turn)) if exact is None else exact if turn >= 0 else 0.0 - exact


_HALF_ROOT_2, _HALF_ROOT_3, _ROOT_3, _THIRD_ROOT_3 = (
    math.sqrt(0.5),
    math.sqrt(3) / 2,
    math.sqrt(3),
    0.57735026918962576451,
)
_QUARTER = ((0.0, 0.0), (30.0, 0.5), (45.0, _HALF_ROOT_2), (60.0, _HALF_ROOT_3), (90.0, 1.0))
_UPPER = {angle: value for a, value in _QUARTER for angle in (a, 180.0 - a)}
_SINES = _UPPER | {180.0 + angle: -value for angle, value in _UPPER.items() if 0 < angle < 180}
_TANGENTS = {
    0.0: 0.0,
    30.0: _THIRD_ROOT_3,
    45.0: 1.0,
    60.0: _ROOT_3,
    120.0: -_ROOT_3,
    135.0: -1.0,
    150.0: -_THIRD_ROOT_3,
}


_MOST = sys.float_info.max


def _finite(value: float) -> float:
    if -_MOST <= value <= _MOST:
        return value
    raise Refusal("domain", "a result beyond the largest number")


def _quotient(a: float, b: float) -> float:
    if b == 0.0:
        raise Refusal("divide-by-zero", "a division by zero")
    return _finite(a / b)


def _tangent(degrees: float) -> float:
    value = tangent(degrees)
    if value is None:
        raise Refusal("domain", "the tangent of an odd multiple of 90 degrees")
    return _finite(value)


def _root(value: float) -> float:
    if value < 0:
        raise Refusal("domain", "the square root of a negative number")
    return math.sqrt(value)


_OPERATIONS: Mapping[str, Callable[[float, float], float]] = {
    "+": lambda a, b: _finite(a + b),
    "-": lambda a, b: _finite(a - b),
    "*": lambda a, b: _finite(a * b),
    "/": _quotient,
}
_FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    "SN": sine,
    "CS": cosine,
    "TAN": _tangent,
    "AT": lambda x: math.degrees(math.atan(x)),
    "ABS": abs,
    "INT": lambda x: float(math.trunc(x)),
    "NEI": nearest,
    "RQ": _root,
}


def _function(text: str, part: Node, read: Read) -> Value:
    name, argument = text[part.children[0].start : part.children[0].end].upper(), part.children[2]
    value = evaluate(text, argument, read)
    if not isinstance(value, float):
        return value
    try:
        return function(name)(value)
    except Refusal as refused:
        return ArithmeticFault(refused.rule, part, refused.why)


def _chain(text: str, part: Node, read: Read) -> Value:
    """Terms or factors from left to right. A fault in any of them counts, even where another is not known."""
    values = [evaluate(text, child, read) for child in part.children[::2]]
    faults = [value for value in values if isinstance(value, ArithmeticFault)]
    signs = [text[sign.start] for sign in part.children[1::2]]
    divisors = zip(signs, values[1:], part.children[2::2])
    zeros = [child for sign, value, child in divisors if sign == "/" and value == 0.0]
    faults += [ArithmeticFault("divide-by-zero", child, "a division by zero") for child in zeros]
    if faults:
        return min(faults, key=lambda fault: fault.part.start)
    known = [value for value in values if isinstance(value, float)]
    return _total(part, known, signs) if len(known) == len(values) else None


def _total(part: Node, values: Sequence[float], signs: Sequence[str]) -> Value:
    total = values[0]
    try:
        for sign, value in zip(signs, values[1:]):
            total = operation(sign)(total, value)
    except Refusal as refused:
        return ArithmeticFault(refused.rule, part, refused.why)
    return total
