"""What an IF of Z32 decides, and what is known where it holds, or does not (spec/z32.md §4, §11). Calculates nothing itself.

Values that are equal in nine digits are equal, so that a bound that is learned lies a little outside.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import CLOSE, COMPARISONS
from deburr.values import operations as on
from deburr.values.domain import NO, Value, above, apart, below
from deburr.values.graph import Env
from deburr.values.remembered import Changes, Remembered, learned
from deburr.values.z32.storing import put

if TYPE_CHECKING:
    from deburr.values.z32.expressions import Expressions, Get
    from deburr.values.z32.text import Text
    from deburr_grammar.tree import Node

_OPPOSITE = {"<": ">=", ">=": "<", ">": "<=", "<=": ">", "=": "<>", "<>": "="}
_MIRRORED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "=": "=", "<>": "<>"}
_MORE, _LESS = CLOSE * (1 + 1e-6), CLOSE * (1 - 1e-6)
_SMALL = 1e8
"""Integers below it are equal only if they are the same."""
_SAME = on.equal(0.5)


Decide = Callable[[Env], tuple[Env | None, Env | None]]


def decision(comparison: Node, expressions: Expressions) -> Callable[[Text], Decide]:
    """Compile a comparison for each line of a shape: what finds the values under which it holds, and those under which it does not. None: it never does."""
    left, *signs, right = comparison.children
    relation = "".join(map(expressions.said, signs)).lower().replace("&lt", "<").replace("&gt", ">")
    one, two = expressions.value(left), expressions.value(right)
    sides: list[tuple[str, Get, Get, str]] = [
        (key, get, other, said)
        for key, get, other, said in (
            (expressions.key(left), one, two, relation),
            (expressions.key(right), two, one, _MIRRORED[relation]),
        )
        if key is not None
    ]

    def found(env: Env) -> tuple[Changes | None, Changes | None]:
        a, b = one(env), two(env)
        known = compared(relation, a, b)
        return (
            None if known is False else learned(env, _learned(sides, env, True)),
            None if known is True else learned(env, _learned(sides, env, False)),
        )

    def bound(text: Text) -> Decide:
        remembered = Remembered(expressions, expressions.of(text, found))

        def decided(env: Env) -> tuple[Env | None, Env | None]:
            held, failed = remembered.of(env)
            return None if held is None else held.on(env), None if failed is None else failed.on(env)

        return decided

    return bound


def _learned(sides: Sequence[tuple[str, Get, Get, str]], env: Env, holds: bool) -> Env | None:
    """What is known where a comparison holds, or does not; None: it never does."""
    for key, get, other, said in sides:
        value = get(env)
        kept = _kept(value, said if holds else _OPPOSITE[said], other(env))
        if kept.impossible:
            return None
        if kept is not value and kept != value:
            env = put(env, key, kept)
    return env


def compared(relation: str, a: Value, b: Value) -> bool | None:
    """Whether a relation holds for all that two sides can be; None: for some."""
    if a.exact and b.exact:
        return COMPARISONS[relation](a.low, b.low)
    if relation in (">", "<="):
        return compared(_MIRRORED[relation], b, a)
    if relation == ">=":
        found = compared("<", a, b)
        return None if found is None else not found
    if relation == "<":
        if a.low >= b.high or _all_equal(a, b):
            return False
        return True if _clearly_less(a, b) else None
    if _all_equal(a, b):
        return relation == "="
    return relation == "<>" if _never_equal(a, b) else None


def _clearly_less(a: Value, b: Value) -> bool:
    """Whether all of the first are less than all of the second. The distance grows faster than what is taken for equal, so the nearest two decide."""
    return a.high < b.low and b.low - a.high > _slack(_MORE, a.high, b.low)


def _all_equal(a: Value, b: Value) -> bool:
    return max(a.high - b.low, b.high - a.low) <= _LESS


def _never_equal(a: Value, b: Value) -> bool:
    if _clearly_less(a, b) or _clearly_less(b, a):
        return True
    return _are_small_integers(a, b) and _SAME(a, b) == NO


def _are_small_integers(a: Value, b: Value) -> bool:
    return a.whole and b.whole and max(-a.low, a.high, -b.low, b.high) < _SMALL


def _slack(within: float, *numbers: float) -> float:
    return within * max(1.0, *map(abs, numbers))


def _kept(value: Value, relation: str, other: Value) -> Value:
    """The values of a side that stand in this relation to one of the other's."""
    match relation:
        case "<":
            return below(value, other.high, True)
        case ">":
            return above(value, other.low, True)
        case "<=":
            return below(value, other.high + _room(value, other, other.high), False)
        case ">=":
            return above(value, other.low - _room(value, other, other.low), False)
        case "=":
            found = below(value, other.high + _room(value, other, other.high), False)
            return above(found, other.low - _room(value, other, other.low), False)
        case _:
            return apart(value, other, CLOSE)


def _room(value: Value, other: Value, bound: float) -> float:
    return 0.0 if _are_small_integers(value, other) else _slack(1.01 * CLOSE, bound)
