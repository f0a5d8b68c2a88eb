"""What the tests of `#IF` and `#IFSTR` ask of words, and what is known where they hold, or do not (spec/cgt.md §5.4, §11). Knows no flow."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.cgt import holds
from deburr.values.domain import (
    EITHER,
    NO,
    NOTHING,
    YES,
    Value,
    above,
    apart,
    below,
    truth,
)
from deburr.values.graph import Env, join

if TYPE_CHECKING:
    from deburr.values.cgt.expressions import Expressions, Texts
    from deburr.values.graph import Key
    from deburr_grammar.tree import Node

_NEAR = 1e-9
_SLACK = 1.1e-9
"""A little more than how near two numbers count as equal, in parts of the greater one."""
_EXACT = 1e8
"""Below it integers that count as equal are the same."""
_MIRRORED = {"=": "=", "<>": "<>", "<": ">", ">": "<", "<=": ">=", ">=": "<="}


class Ways(NamedTuple):
    """The values under which a test holds, and under which it does not; None: there are none."""

    then: Env | None
    otherwise: Env | None


Test = Callable[[Env], Ways]


def tests(expressions: Expressions, part: Node) -> Test:
    """The tests of an `#IF` or `#IFSTR`, joined from left to right; all of them are calculated."""
    parts = [each for each in part.children if each.kind != "COMMA"]
    made = [
        (_numeric if test.kind == "test" else _textual)(expressions, test)  # type: ignore[arg-type]  # tests are nodes
        for test in parts[::2]
    ]
    signs = [expressions.said(sign).upper() == "#AND" for sign in parts[1::2]]
    first, rest = made[0], tuple(zip(signs, made[1:]))
    if not rest:
        return first

    def found(env: Env) -> Ways:
        for _, test in rest:
            test(env)
        ways = first(env)
        for both, test in rest:
            ways = _and(ways, test) if both else _and(Ways(ways.otherwise, ways.then), _opposite(test))
            ways = ways if both else Ways(ways.otherwise, ways.then)
        return ways

    return found


def _and(ways: Ways, test: Test) -> Ways:
    """Where both hold, and where one does not."""
    if ways.then is None:
        return ways
    second = test(ways.then)
    return Ways(second.then, _either(ways.otherwise, second.otherwise))


def _opposite(test: Test) -> Test:
    def found(env: Env) -> Ways:
        then, otherwise = test(env)
        return Ways(otherwise, then)

    return found


def _either(one: Env | None, two: Env | None) -> Env | None:
    return two if one is None else one if two is None else join(one, two)


def _numeric(expressions: Expressions, test: Node) -> Test:
    left, relation, right = test.children
    sign = expressions.said(relation)
    sides = (
        (_numbered(expressions, left), expressions.number(left), expressions.number(right), sign),
        (_numbered(expressions, right), expressions.number(right), expressions.number(left), _MIRRORED[sign]),
    )
    one, two = sides[0][1:3]

    def under(env: Env, holding: bool) -> Env | None:
        found: Env | None = env
        for key, get, other, relation in sides:
            if key is None or found is None:
                continue
            old = get(found)
            new = _kept(old, relation, other(found), holding)
            found = None if new.impossible else found if new == old else _with(found, key, new)
        return found

    def asked(env: Env) -> Ways:
        known = truth(compared(sign, one(env), two(env)))
        return Ways(
            under(env, True) if known in (None, True) else None, under(env, False) if known in (None, False) else None
        )

    return asked


def _numbered(expressions: Expressions, part: object) -> Key | None:
    """The word that a side is, if it holds numbers."""
    word = expressions.word(part)  # type: ignore[arg-type]  # sides are parts of a tree
    return None if word is None or word.is_text else expressions.key(part)  # type: ignore[arg-type]


def _with(env: Env, key: Key, value: Value) -> Env:
    return {**env, key: value}


def compared(sign: str, a: Value, b: Value) -> Value:
    """Whether a comparison holds, as far as it is known."""
    if a.empty or b.empty:
        return EITHER
    if a.low == a.high and b.low == b.high:
        return YES if holds(sign, a.low, b.low) else NO
    match sign:
        case "=" | "<>":
            found = NO if _parted(a, b) or _parted(b, a) or _missed(a, b) or _missed(b, a) else EITHER
            return found if sign == "=" or found == EITHER else YES
        case "<":
            return YES if a.high < b.low else NO if a.low >= b.high else EITHER
        case "<=":
            return YES if a.high <= b.low else NO if _parted(b, a) else EITHER
        case _:
            return compared(_MIRRORED[sign], b, a)


def _parted(a: Value, b: Value) -> bool:
    """Whether all of the first are less than all of the second, and none counts as equal to one."""
    greatest = max(map(abs, (a.low, a.high, b.low, b.high)))
    return b.low > a.high and (b.low - a.high > _SLACK * greatest or _sure(a, b))


def _missed(a: Value, b: Value) -> bool:
    """Whether the second is a number that is none of the first, and near to none."""
    if b.low != b.high or not a.low < b.low < a.high:
        return False
    return (b.low == 0 or _sure(a, b)) and not a.has(b.low)


def _sure(a: Value, b: Value) -> bool:
    """Whether both are so small integers that those that count as equal are the same."""
    return a.whole and b.whole and max(map(abs, (a.low, a.high, b.low, b.high))) < _EXACT


def _kept(value: Value, relation: str, other: Value, holding: bool) -> Value:
    """The values of a side that stand in this relation to one of the other's, or do not."""
    if value.wild or other.wild or other.empty or value.empty:
        return value
    match (relation, holding):
        case ("<", True):
            return below(value, other.high, True)
        case ("<", False):
            return above(value, other.low, False)
        case (">", True):
            return above(value, other.low, True)
        case (">", False):
            return below(value, other.high, False)
        case ("<=", True):
            return below(value, _up(other.high, value, other), False)
        case ("<=", False):
            return above(value, other.low, True)
        case (">=", True):
            return above(value, -_up(-other.low, value, other), False)
        case (">=", False):
            return below(value, other.high, True)
        case ("=", True) | ("<>", False):
            return above(below(value, _up(other.high, value, other), False), -_up(-other.low, value, other), False)
        case _:
            return apart(value, other, _NEAR * abs(other.low)) if other.exact and abs(other.low) < _EXACT else value


def _up(bound: float, value: Value, other: Value) -> float:
    """A bound with what counts as equal to it."""
    if not math.isfinite(bound) or (value.whole and other.whole and abs(bound) < _EXACT):
        return bound
    return bound + _SLACK * abs(bound)


def _textual(expressions: Expressions, test: Node) -> Test:
    left, relation, *right = test.children
    same = expressions.said(relation) == "="
    said = right[0] if right else None
    two: Texts = expressions.text(said)
    if said is not None and said.kind != "WORD":
        text = frozenset((expressions.said(said),))
        two = lambda env: text  # noqa: E731  # the text as it stands, not read as an expression
    one = expressions.text(left)
    keys = (_texts(expressions, left), _texts(expressions, said) if said is not None else None)

    def asked(env: Env) -> Ways:
        a, b = one(env), two(env)
        alike = _alike(env, keys, a, b)
        differing = env if a is None or b is None or len(_trimmed(a) | _trimmed(b)) > 1 else None
        if differing is not None:
            differing = _differing(differing, keys, a, b)
        return Ways(alike, differing) if same else Ways(differing, alike)

    return asked


def _texts(expressions: Expressions, part: object) -> Key | None:
    """The word that a side is, if it holds texts."""
    word = expressions.word(part)  # type: ignore[arg-type]  # sides are parts of a tree
    return expressions.key(part) if word is not None and word.is_text else None  # type: ignore[arg-type]


def _alike(
    env: Env, keys: tuple[Key | None, Key | None], a: frozenset[str] | None, b: frozenset[str] | None
) -> Env | None:
    """The values under which two texts are the same."""
    if a is None or b is None:
        return env
    common = _trimmed(a) & _trimmed(b)
    if not common:
        return None
    return _restricted(env, keys, (a, b), lambda text: text.strip(" \t") in common)


def _differing(
    env: Env, keys: tuple[Key | None, Key | None], a: frozenset[str] | None, b: frozenset[str] | None
) -> Env:
    """The values under which they are not."""
    if a is None or b is None:
        return env
    for key, texts, other in zip(keys, (a, b), (b, a)):
        if key is not None and len(_trimmed(other)) == 1:
            env = _restricted(env, (key,), (texts,), lambda text, other=other: text.strip(" \t") not in _trimmed(other))  # type: ignore[misc]
    return env


def _restricted(
    env: Env, keys: tuple[Key | None, ...], texts: tuple[frozenset[str], ...], keep: Callable[[str], bool]
) -> Env:
    found = dict(env)
    for key, each in zip(keys, texts):
        if key is not None:
            found[key] = NOTHING._replace(texts=frozenset(filter(keep, each)))
    return found


def _trimmed(texts: frozenset[str]) -> frozenset[str]:
    return frozenset(text.strip(" \t") for text in texts)
