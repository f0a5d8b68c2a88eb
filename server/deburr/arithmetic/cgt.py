"""CGT's arithmetic: operators, functions, comparison and rounding (spec/cgt.md §5.8, §11). Never formats a number for output."""

from __future__ import annotations

import math
from decimal import ROUND_HALF_UP, Decimal, localcontext
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.arithmetic import ArithmeticFault
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

Value = float | ArithmeticFault | None
_DIGITS = 1_000
"""More digits than any double needs: the largest has 309 before the point, the smallest 324 behind it."""
_NEAR = 1e-9


class Refused(NamedTuple):
    """An operation that has no value: the rule's short name and why."""

    rule: str
    why: str


def operate(sign: str, a: float, b: float) -> float | Refused:
    """The value of `a sign b` for `+ - * / ^`."""
    if b == 0 and sign == "/":
        return Refused("divide-by-zero", "a division by zero")
    if sign == "^" and a == 0 and b < 0:
        return Refused("divide-by-zero", "a division by zero")
    if sign == "^" and a < 0 and b != math.floor(b):
        return Refused("math", "a negative number raised to a power that is no integer")
    return _finite(lambda: _OPERATORS[sign](a, b))


def call(name: str, arguments: tuple[float, ...]) -> float | Refused | None:
    """The value of a numeric function, its name in any case; None for one that is unknown or needs more than numbers."""
    name = name.upper()
    counted = _FUNCTIONS.get(name)
    if counted is None or counted[0] != len(arguments):
        return None
    refuses, refused = _DOMAINS.get(name, (None, None))
    if refuses is not None and refused is not None and refuses(arguments):
        return refused
    return _finite(lambda: counted[1](*arguments))


def part_of(text: str, start: float, length: float) -> str | Refused:
    """STRSUB: characters from ``start`` on, counted from 1, as far as the text goes."""
    if start < 1 or length < 0:
        return Refused("math", "a part of a text that starts before its first character or has a negative length")
    first = int(start) - 1
    return text[first : first + int(length)]


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
    for value in (a, b):
        if isinstance(value, ArithmeticFault):
            return value
    said = text[sign.start : sign.end]
    if a is None and said == "/":
        # Only a divisor decides alone: whatever is divided, a zero is refused.
        a = 1.0 if b == 0 else None
    if not isinstance(a, float) or not isinstance(b, float):
        return None
    result = operate(said, a, b)
    if isinstance(result, Refused):
        return ArithmeticFault(result.rule, right if said == "/" and b == 0 else part, result.why)
    return result


def _function(text: str, part: Node) -> Value:
    name = text[part.children[0].start : part.children[0].end].upper()
    parts = arguments_of(part)
    values = tuple(constant(text, argument) for argument in parts)
    fault = next((value for value in values if isinstance(value, ArithmeticFault)), None)
    if fault is not None:
        return fault
    numbers = tuple(value for value in values if isinstance(value, float))
    value: float | Refused | None
    if (name in ("MOD", "STRSUB") and len(numbers) < len(parts)) or name == "STRSUB":
        value = _decided_by_rest(name, values)
    else:
        value = call(name, numbers) if len(numbers) == len(parts) else None
    if isinstance(value, Refused):
        return ArithmeticFault(value.rule, parts[1] if value.rule == "divide-by-zero" else part, value.why)
    return value


def _decided_by_rest(name: str, values: tuple[Value, ...]) -> Refused | None:
    """A zero divisor or a start before the text is refused whatever the first argument is."""
    numbers = tuple(value if isinstance(value, float) else 1.0 for value in values)
    refused: float | Refused | None = None
    if name == "MOD" and len(numbers) == 2:
        refused = call("MOD", (1.0, numbers[1]))
    elif name == "STRSUB" and len(numbers) == 3 and isinstance(found := part_of("", numbers[1], numbers[2]), Refused):
        refused = found
    return refused if isinstance(refused, Refused) else None


def _finite(calculate: Callable[[], float]) -> float | Refused:
    try:
        value = calculate()
    except (OverflowError, ValueError, ZeroDivisionError):
        value = math.inf
    return value if math.isfinite(value) else Refused("math", "a result that is no finite number")


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
    return sine / cosine


_OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "^": math.pow,
}
_FUNCTIONS: dict[str, tuple[int, Callable[..., float]]] = {
    "ABS": (1, abs),
    "ACOS": (1, lambda a: math.degrees(math.acos(a))),
    "ASIN": (1, lambda a: math.degrees(math.asin(a))),
    "ATAN": (1, lambda a: math.degrees(math.atan(a))),
    "CEIL": (1, lambda a: float(math.ceil(a))),
    "COS": (1, lambda a: _sine_cosine(a)[1]),
    "DMS": (1, _degrees),
    "FLOOR": (1, lambda a: float(math.floor(a))),
    "INT": (1, lambda a: float(math.trunc(a))),
    "MAX": (2, max),
    "MIN": (2, min),
    "MOD": (2, lambda a, b: math.fmod(math.trunc(a), math.trunc(b))),
    "PI": (0, lambda: math.pi),
    "RND": (2, lambda a, places: float(rounded(a, math.trunc(places)))),
    "SGN": (1, lambda a: float((a > 0) - (a < 0))),
    "SIN": (1, lambda a: _sine_cosine(a)[0]),
    "SQR": (1, math.sqrt),
    "TAN": (1, _tangent),
}
_DOMAINS: dict[str, tuple[Callable[[tuple[float, ...]], bool], Refused]] = {
    "ACOS": (lambda a: abs(a[0]) > 1, Refused("math", "ACOS of a number outside -1 to 1")),
    "ASIN": (lambda a: abs(a[0]) > 1, Refused("math", "ASIN of a number outside -1 to 1")),
    "MOD": (lambda a: math.trunc(a[1]) == 0, Refused("divide-by-zero", "a remainder of a division by zero")),
    "SQR": (lambda a: a[0] < 0, Refused("math", "the square root of a negative number")),
    "TAN": (lambda a: _sine_cosine(a[0])[1] == 0, Refused("math", "a tangent that is not finite")),
}
