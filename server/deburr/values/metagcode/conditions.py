"""What MetaGCODE's conditions ask of variables, and what is known where they hold, or do not (spec/metagcode.md §5.3). Knows no flow.

Bounds are doubles around exact decimals, and never strict but at 0.
"""

from __future__ import annotations

import math
from decimal import Decimal
from typing import NamedTuple

from deburr.values import operations as on
from deburr.values.domain import NO, NOTHING, WILD, Value, above, below, exactly, may_be_zero, without_zero
from deburr.values.graph import Env, Proof
from deburr_grammar.dialects.metagcode.forms import name, number
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Token

_TINY = 5e-324
_EQUAL = on.equal(_TINY)
COMPARED: dict[str, on.Lifted] = {
    "greaterthan": on.swapped(on.less),
    "lessthan": on.less,
    "equalto": _EQUAL,
    "notequalto": on.negated(_EQUAL),
}
_OPPOSITE = {"greaterthan": "most", "lessthan": "least", "equalto": "notequalto", "notequalto": "equalto"}
_MIRRORED = {"greaterthan": "lessthan", "lessthan": "greaterthan", "equalto": "equalto", "notequalto": "notequalto"}


class Item(NamedTuple):
    """A value on a directive's line: the name of its variable or what the number is that stands there, its columns, and how it is written."""

    name: str | None
    literal: Value
    span: Span
    said: str

    def of(self, env: Env) -> Value:
        """What it stands for."""
        return self.literal if self.name is None else env.get(self.name, WILD)


def item_of(line: LineNode, token: Token) -> Item:
    """The item that a token is."""
    said, span = line.text[token.start : token.end], Span(token.start, token.end)
    if token.kind == "VARIABLE":
        return Item(name(said), WILD, span, said)
    return Item(None, _literal(said), span, said)


def _literal(said: str) -> Value:
    """What a text is as a number; one that is none is only wild."""
    value = number(said)
    return NOTHING._replace(wild=True) if value is None else _around(value)


def _around(value: Decimal) -> Value:
    """A decimal between the doubles around it."""
    near = float(value)
    if not math.isfinite(near):
        return Value(*((-math.inf, -1e300) if value < 0 else (1e300, math.inf)))
    if Decimal(near) == value:
        return exactly(near)
    return Value(math.nextafter(near, -math.inf), math.nextafter(near, math.inf))


def under(env: Env, left: Item, word: str, right: Item, holds: bool) -> Env | None:
    """The values under which a numeric comparison is true, or false; None: it never is."""
    found = dict(env)
    for item, relation, other in ((left, word, right), (right, _MIRRORED[word], left)):
        if item.name is not None:
            value = kept(item.of(found), relation, finite(other.of(found)), holds)
            if value.impossible:
                return None
            found[item.name] = value
    return found


def mirrored(word: str) -> str:
    """What the right side is to the left one."""
    return _MIRRORED[word]


def kept(value: Value, relation: str, other: Value, holds: bool) -> Value:
    """The values of a side that stand in a relation to one of the other's, or do not."""
    if other.empty:
        return value
    match relation if holds else _OPPOSITE[relation]:
        case "greaterthan":
            found = above(value, other.low, False)
            return without_zero(found) if other.low == 0 else found
        case "lessthan":
            found = below(value, other.high, False)
            return without_zero(found) if other.high == 0 else found
        case "least":
            return above(value, other.low, False)
        case "most":
            return below(value, other.high, False)
        case "equalto":
            return below(above(value, other.low, False), other.high, False)
        case _:
            return without_zero(value) if other == NO else value


def spelled_alike(env: Env, left: Item, right: Item) -> Env | None:
    """The values under which two texts are the same, if one of them stands in the line; None: they never are."""
    for item, other in ((left, right), (right, left)):
        if item.name is not None and other.name is None:
            value, meant = item.of(env), other.literal
            if meant.empty:
                return {**env, item.name: meant} if value.wild else None
            found = below(above(finite(value), meant.low, False), meant.high, False)
            return None if found.empty else {**env, item.name: found}
    return env


def as_number(item: Item, env: Env) -> Value:
    """The value of a variable where a number must stand."""
    value = item.of(env)
    if value.empty and value.wild:
        message = (
            f"`|{item.name}|` is compared before with a text that is no number, so there is nothing to calculate with"
        )
        raise Proof("not-numeric", item.span, message)
    return finite(value)


def is_negative(value: Value) -> bool:
    """Whether all that it can be are numbers below 0."""
    return value.high <= 0 and not may_be_zero(value) and not value.wild and not value.empty


def finite(value: Value) -> Value:
    """What is left where a number must stand."""
    return value._replace(wild=False) if value.wild else value
