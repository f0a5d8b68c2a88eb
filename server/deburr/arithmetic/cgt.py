"""CGT's arithmetic: operators, functions, comparison and rounding (spec/cgt.md §5.8, §11). Never formats a number for output."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal, localcontext
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.arithmetic import ArithmeticFault, Refusal, tried
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

Value = float | ArithmeticFault | None
_DIGITS = 1_000
"""More digits than any double needs: the largest has 309 before the point, the smallest 324 behind it."""
_NEAR = 1e-9


class Function(NamedTuple):
    """A numeric function: how many arguments it takes, and what applies it; that raises `Refusal` where there is no value."""

    takes: int
    apply: Callable[..., float]


def operation(sign: str) -> Callable[[float, float], float]:
    """What applies one of `+ - * / ^`; it raises `Refusal` where there is no value."""
    return _OPERATORS[sign]


def function(name: str) -> Function | None:
    """A numeric function, its name in any case; None for one that is unknown or needs more than numbers."""
    return _FUNCTIONS.get(name.upper())


def part_of(text: str, start: float, length: float) -> str:
    """STRSUB: characters from ``start`` on, counted from 1, as far as the text goes."""
    if start < 1 or length < 0:
        raise Refusal("math", "a part of a text that starts before its first character or has a negative length")
    first = int(start) - 1
    return text[first : first + int(length)]


def finite(value: float) -> float:
    """A result, if it is one."""
    if math.isfinite(value):
        return value
    raise Refusal("math", "a result that is no finite number")


def equal(a: float, b: float) -> bool:
    """Whether two numbers count as equal (spec/cgt.md §11, *EVAL and formats*)."""
    return a == b or abs(a - b) < _NEAR * max(abs(a), abs(b))


def holds(relation: str, a: float, b: float) -> bool:
    """Whether a comparison of two numbers holds; `>=` and `<=` include what counts as equal."""
    same = equal(a, b)
    match relation:
        case "=":
            return same
        case "<>":
            return not same
        case ">=":
            return same or a > b
        case "<=":
            return same or a < b
        case ">":
            return a > b
        case _:
            return a < b


def rounded(value: float, places: int) -> Decimal:
    """The shortest decimal text of a number, rounded to that many decimals, halves away from 0."""
    with localcontext() as context:
        context.prec = _DIGITS
        return Decimal(repr(value)).quantize(Decimal(1).scaleb(-max(-400, min(400, places))), ROUND_HALF_UP)


def constant(text: str, part: Node | Token, settings: Mapping[str, Any] | None = None) -> Value:
    """The value of a part of a line if it follows from the line alone; a fault if it has none on any run."""
    if isinstance(part, Token):
        if part.kind == "NUMBER":
            number = float(text[part.start : part.end])
            return number if math.isfinite(number) else ArithmeticFault("math", part, "a number that is too large")
        return math.pi if part.kind == "PI" else None
    match part.kind:
        case "group":
            return constant(text, part.children[1])
        case "signed" | "negative":
            value = constant(text, part.children[1])
            return -value if isinstance(value, float) and text[part.start] == "-" else value
        case "sum" | "product" | "quotient" | "power":
            return _operation(text, part)
        case "function":
            return _function(text, part)
        case _:
            return None


def arguments_of(function: Node) -> tuple[Node | Token, ...]:
    """The arguments of a function call."""
    return tuple(part for part in function.children[2:-1] if part.kind != "COMMA")


def _operation(text: str, part: Node) -> Value:
    left, sign, right = part.children
    a, b = constant(text, left), constant(text, right)
    said = text[sign.start : sign.end]
    if a is None and said == "/" and b == 0:
        # Only a divisor decides alone: whatever is divided, a zero is refused.
        a = 1.0
    return tried(operation(said), part, right if said == "/" and b == 0 else part, a, b)


def _function(text: str, part: Node) -> Value:
    name = text[part.children[0].start : part.children[0].end].upper()
    parts = arguments_of(part)
    values = tuple(constant(text, argument) for argument in parts)
    if name == "STRSUB" and len(values) == 3:
        # A start before the text is refused whatever the text is.
        values = (0.0 if values[0] is None else values[0], *values[1:])
        found = tried(lambda _, start, length: float(len(part_of("", start, length))), part, part, *values)
        return found if isinstance(found, ArithmeticFault) else None
    known = function(name)
    if known is None or known.takes != len(parts):
        return next((value for value in values if isinstance(value, ArithmeticFault)), None)
    if name == "MOD" and values[0] is None and values[1] is not None:
        found = tried(known.apply, part, parts[1], 1.0, values[1])
        return found if isinstance(found, ArithmeticFault) else None
    return tried(known.apply, part, parts[-1] if parts else part, *values)


def _divided(a: float, b: float) -> float:
    if b == 0:
        raise _by_zero("a division by zero")
    return finite(a / b)


def _raised(a: float, b: float) -> float:
    if a == 0 and b < 0:
        raise _by_zero("a division by zero")
    if a < 0 and b != math.floor(b):
        raise Refusal("math", "a negative number raised to a power that is no integer")
    try:
        return math.pow(a, b)
    except OverflowError:
        return finite(math.inf)


def _remainder(a: float, b: float) -> float:
    if math.trunc(b) == 0:
        raise _by_zero("a remainder of a division by zero")
    return math.fmod(math.trunc(a), math.trunc(b))


def _by_zero(why: str) -> Refusal:
    return Refusal("divide-by-zero", why)


def _within_one(name: str, inverse: Callable[[float], float]) -> Callable[[float], float]:
    def found(a: float) -> float:
        if abs(a) > 1:
            raise Refusal("math", f"{name} of a number outside -1 to 1")
        return math.degrees(inverse(a))

    return found


def _root(a: float) -> float:
    if a < 0:
        raise Refusal("math", "the square root of a negative number")
    return math.sqrt(a)


def _degrees(text: float) -> float:
    """Decimal degrees of an angle written ddd.mmss."""
    with localcontext() as context:
        context.prec = _DIGITS
        said = abs(Decimal(repr(text)))
        whole = int(said)
        minutes = (said - whole) * 100
        seconds = (minutes - int(minutes)) * 100
        return math.copysign(float(whole + Decimal(int(minutes)) / 60 + seconds / 3600), text)


_QUARTERS = {0.0: (0.0, 1.0), 90.0: (1.0, 0.0), 180.0: (0.0, -1.0), 270.0: (-1.0, 0.0)}


def _sine_cosine(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in degrees, exact on the axes, where a machine part must not get a stray digit."""
    turned = math.fmod(angle, 360.0) % 360.0
    return _QUARTERS.get(turned) or (math.sin(math.radians(turned)), math.cos(math.radians(turned)))


def _tangent(angle: float) -> float:
    sine, cosine = _sine_cosine(angle)
    if cosine == 0:
        raise Refusal("math", "a tangent that is not finite")
    return sine / cosine


_OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: finite(a + b),
    "-": lambda a, b: finite(a - b),
    "*": lambda a, b: finite(a * b),
    "/": _divided,
    "^": _raised,
}
_FUNCTIONS: dict[str, Function] = {
    "ABS": Function(1, abs),
    "ACOS": Function(1, _within_one("ACOS", math.acos)),
    "ASIN": Function(1, _within_one("ASIN", math.asin)),
    "ATAN": Function(1, lambda a: math.degrees(math.atan(a))),
    "CEIL": Function(1, lambda a: float(math.ceil(a))),
    "COS": Function(1, lambda a: _sine_cosine(a)[1]),
    "DMS": Function(1, lambda a: finite(_degrees(a))),
    "FLOOR": Function(1, lambda a: float(math.floor(a))),
    "INT": Function(1, lambda a: float(math.trunc(a))),
    "MAX": Function(2, max),
    "MIN": Function(2, min),
    "MOD": Function(2, _remainder),
    "PI": Function(0, lambda: math.pi),
    "RND": Function(2, lambda a, places: finite(float(rounded(a, math.trunc(places))))),
    "SGN": Function(1, lambda a: float((a > 0) - (a < 0))),
    "SIN": Function(1, lambda a: _sine_cosine(a)[0]),
    "SQR": Function(1, _root),
    "TAN": Function(1, _tangent),
}
