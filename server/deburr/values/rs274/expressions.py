"""RS274's expressions on values as closures: the language's own operators and functions, on all that a parameter can hold (spec/rs274.md §3, §4)."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping, Sequence
from functools import cache, lru_cache
from typing import Any

from deburr.arithmetic import Refusal
from deburr.arithmetic.rs274 import TOLERANCE, atan, canonical, function, number, operation
from deburr.values import operations as on
from deburr.values.domain import ANY, EITHER, Value, exactly, joined, read
from deburr.values.graph import Env, Proof
from deburr_grammar.dialects.rs274.names import name_of
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

Get = Callable[[Env], Value]
NEAR = 1e-4
LAST = {"linuxcnc": 5601, "smithy": 5399}
READ_ONLY = frozenset((*range(5400, 5414), *range(5420, 5429)))
ARGUMENTS = 30
"""#1 to #30 belong to a call."""
FREE = 5000
"""Above it the control sets parameters, too: nothing is ever known of them."""
_MAY_BE_INFINITE = frozenset(("sum", "product", "quotient", "modulo", "power"))
_OPERATIONS = _MAY_BE_INFINITE | {"comparison", "logical"}
_SHARED = 1_024
"""So much of what hangs on no line is kept."""
_MOST = 40
"""Of so many parameters the values are joined where one of them is meant."""


class Expressions:
    """Compiles the expressions of one line. ``used``: the parameters that they read; None among them: who knows which."""

    __slots__ = ("_begun", "_last", "_near", "_text", "_to", "dialect", "doubtful", "used")

    def __init__(self, line: LineNode, settings: Mapping[str, Any]) -> None:
        """``line``: parts of its shape's tree are compiled, because all lines of a shape share that one."""
        shape = line.shape.text
        self._text = line.text
        self._to = None if line.text == shape else line.dialect.folding.columns(line.text).table(len(shape))
        self._near = TOLERANCE[settings["compare"]]
        self._last = LAST[settings["profile"]]
        self.dialect = line.dialect
        self._begun: set[str] = set()
        self.used: set[Hashable] = set()
        self.doubtful = False
        """Whether something may have failed since it was last set to False."""

    def is_doubtful(self) -> bool:
        """The same, as a node is asked."""
        return self.doubtful

    def value(self, part: Node | Token) -> Get:
        """What calculates the value of a part of the shape's tree."""
        if isinstance(part, Token):
            return _literally(self.said(part))
        if part.kind in _OPERATIONS:
            left, sign, right = part.children
            return self._applied(part, lifted_operation(self.spelled(sign), self._near), left, right)
        match part.kind:
            case "signed":
                inner = self.value(part.children[1])
                return inner if self.said(part).startswith("+") else _negative(inner)
            case "param":
                return self._read(part)
            case "function":
                return self._applied(part, FUNCTIONS[self.spelled(part.children[0])], part.children[1])
            case "atan":
                return self._applied(part, ATAN, part.children[1], part.children[3])
            case "exists":
                return self._exists(part)
            case "group":
                return self._group(part)
            case _:
                return self.value(part.children[0])

    def target(self, param: Node) -> Callable[[Env], tuple[Hashable, ...] | None]:
        """What finds out which parameters a setting may set; None: who knows which."""
        name = self.name(param)
        if name is not None:
            self._begun.add(name)
            return self._named_target(name)
        at = self.literal(param)
        if at is not None:
            return _only(at)
        return self._computed_target(param)

    def _computed_target(self, param: Node) -> Callable[[Env], tuple[Hashable, ...] | None]:
        index = self._index(param)

        def found(env: Env) -> tuple[Hashable, ...] | None:
            value = index(env)
            if value.exact and round(value.low) in READ_ONLY:
                message = f"`{self.said(param)}` is #{round(value.low)} here, which is read-only"
                raise self.proof("param-readonly", param, message)
            self.doubtful = self.doubtful or (value.low < 5429 and value.high > 5399)
            return _numbers(value)

        return found

    def name(self, param: Node) -> str | None:
        """The name of a named parameter as the control compares it; None for a numbered one."""
        said = param.children[1]
        return name_of(self.said(said)) if said.kind == "NAME" else None

    def literal(self, param: Node) -> int | None:
        """The number of a parameter that is written out and of which values are known."""
        index = param.children[1]
        said = self.said(index).strip() if isinstance(index, Token) and index.kind == "NUMBER" else ""
        return int(said) if said.isdigit() and len(said) < 5 and 0 < int(said) <= FREE else None

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        span = self.span(part)
        return self._text[span.start : span.end]

    def spelled(self, part: Node | Token) -> str:
        """An operator's or a function's canonical spelling."""
        return canonical(self.said(part))

    def span(self, part: Node | Token) -> Span:
        """The columns of a part in the line."""
        if self._to is None:
            return Span(part.start, part.end)
        return Span(self._to[part.start], self._to[part.end])

    def is_predefined(self, name: str) -> bool:
        """Whether only the control sets a name."""
        if not name.startswith("_"):
            return False
        return name.startswith(("_hal[", "_ini[", "_abs_")) or self.dialect.codes.entry("variable", name) is not None

    def proof(self, kind: str, part: Node | Token, message: str) -> Proof:
        """What is certain to go wrong at a part of this line."""
        return Proof(kind, self.span(part), message)

    def _applied(self, part: Node, apply: on.Lifted, *operands: Node | Token) -> Get:
        gets = [self.value(operand) for operand in operands]
        may_refuse = part.kind in ("quotient", "power") or apply in _MAY_REFUSE
        if not may_refuse and len(gets) == 2:
            # Nothing can go wrong here: most operations are of this sort.
            return _both(apply, *gets)
        return self._may_refuse(part, apply, gets, may_refuse)

    def _may_refuse(self, part: Node, apply: on.Lifted, gets: Sequence[Get], may_refuse: bool) -> Get:
        def found(env: Env) -> Value:
            values = [get(env) for get in gets]
            try:
                value = apply(*values)
            except Refusal as refused:
                raise self._refused(part, refused) from None
            self.doubtful = self.doubtful or (may_refuse and not all(v.exact for v in values))
            return value

        return found

    def _refused(self, part: Node, refused: Refusal) -> Proof:
        at = part.children[2] if refused.rule == "divide-by-zero" else part
        return self.proof(refused.rule, at, f"`{self.said(part)}` is {refused.why}; the control stops here")

    def _group(self, part: Node) -> Get:
        inner = part.children[1]
        get = self.value(inner)
        if not isinstance(inner, Node) or inner.kind not in _MAY_BE_INFINITE:
            return get

        def found(env: Env) -> Value:
            value = get(env)
            if not value.wild:
                return value
            self.doubtful = True
            try:
                return on.finite(value)
            except Refusal as refused:
                raise self._refused(part, refused) from None

        return found

    def _exists(self, part: Node) -> Get:
        """Whether a name is set; 0 where it is set on no way to this place, so that what hangs on it is never reached."""
        param = part.children[2]
        name = self.name(param) if isinstance(param, Node) and param.kind == "param" else None
        if name is None or name in self._begun or self.is_predefined(name):
            return lambda env: EITHER
        self.used.add(name)

        def found(env: Env) -> Value:
            value = env.get(name, ANY)
            return exactly(0.0) if value.unset and value.empty and not value.wild else EITHER

        return found

    def _read(self, param: Node) -> Get:
        name = self.name(param)
        if name is not None:
            return self._read_named(param, name)
        at = self.literal(param)
        if at is not None:
            self.used.add(at)
            return _numbered(at)
        return self._read_computed(param)

    def _read_computed(self, param: Node) -> Get:
        index = self._index(param)

        def found(env: Env) -> Value:
            keys = _numbers(index(env))
            return on.union([env.get(key, ANY) for key in keys]) if keys else ANY

        return found

    def _index(self, param: Node) -> Get:
        part = param.children[1]
        get, last = self.value(part), self._last
        if isinstance(part, Token):
            self.used.add(round(min(number(self.said(part)), 1e9)))
        else:
            self.used.add(None)

        def found(env: Env) -> Value:
            value = get(env)
            if value.exact and abs(value.low - round(value.low)) > NEAR:
                message = f"`{self.said(part)}` is {value.low:g} here, and must be an integer"
                raise self.proof("integer-required", part, message)
            if not value.wild and (value.exact or value.whole) and (value.high < 0.5 or value.low > last + 0.5):
                raise self.proof("param-range", param, self._out_of_range(param, value))
            self.doubtful = self.doubtful or not (value.whole and value.low >= 1 and value.high <= last)
            return value

        return found

    def _out_of_range(self, param: Node, value: Value) -> str:
        which = f"#{value.low:.0f}" if value.exact else f"none from 1 to {self._last}"
        return f"`{self.said(param)}` is parameter {which} here; they go from 1 to {self._last}"

    def _read_named(self, param: Node, name: str) -> Get:
        self.used.add(name)
        if self.is_predefined(name):
            return _anything
        return _Named(self, param, name, name in self._begun)

    def _named_target(self, name: str) -> Callable[[Env], tuple[Hashable, ...] | None]:
        if not self.is_predefined(name):
            return _only(name)

        def found(env: Env) -> tuple[Hashable, ...]:
            self.doubtful = True
            return ()

        return found


class _Named:
    """What reads a named parameter: most of what lines read, so it is one object and no function with its own room."""

    __slots__ = ("_begun", "_expressions", "_name", "_param")

    def __init__(self, expressions: Expressions, param: Node, name: str, begun: bool) -> None:
        """``begun``: whether the line itself sets it, so that it exists."""
        self._expressions = expressions
        self._param = param
        self._name = name
        self._begun = begun

    def __call__(self, env: Env) -> Value:
        value = env.get(self._name, ANY)
        return self._unset(value) if value.unset else value

    def _unset(self, value: Value) -> Value:
        if self._begun:
            return joined(read(value), exactly(0.0))
        expressions, param = self._expressions, self._param
        expressions.doubtful = True
        if value.empty and not value.wild:
            message = f"`{expressions.said(param)}` has no value here, on whatever way the program comes to this line; the control stops"
            raise expressions.proof("named-undefined", param, message)
        return read(value)


@lru_cache(maxsize=_SHARED)
def _literally(said: str) -> Get:
    value = exactly(number(said))
    return lambda env: value


@lru_cache(maxsize=_SHARED)
def _numbered(at: int) -> Get:
    return lambda env: env.get(at, ANY)


@lru_cache(maxsize=_SHARED)
def _only(key: Hashable) -> Callable[[Env], tuple[Hashable, ...] | None]:
    keys = (key,)
    return lambda env: keys


def _both(apply: on.Lifted, left: Get, right: Get) -> Get:
    return lambda env: apply(left(env), right(env))


def _negative(inner: Get) -> Get:
    return lambda env: on.negative(inner(env))


def _anything(env: Env) -> Value:
    return ANY


def _numbers(value: Value) -> tuple[Hashable, ...] | None:
    """The numbered parameters that an index may mean, without those of which nothing is known; None: too many."""
    if value.wild or value.empty or value.high - value.low > _MOST:
        return None
    first, last = math.ceil(value.low - 0.5), math.floor(value.high + 0.5)
    if last > FREE:
        return None if first <= FREE else ()
    return tuple(at for at in range(first, last + 1) if not value.step or value.has(float(at)))


@cache
def lifted_operation(sign: str, near: float) -> on.Lifted:
    """A binary operator on values. ``near``: how near two values are that are EQ."""
    apply = operation(sign, near)
    tolerant = near if near < TOLERANCE["1e-4"] else 0.0
    ranges: dict[str, on.Lifted] = {
        "+": on.plus,
        "-": on.minus,
        "*": on.times,
        "/": on.divided(apply),
        "MOD": on.modulo(apply),
        "**": on.power(apply),
        "LT": on.less,
        "GT": on.swapped(on.less),
        "LE": on.at_most(tolerant),
        "GE": on.swapped(on.at_most(tolerant)),
        "EQ": on.equal(near),
        "NE": on.negated(on.equal(near)),
        "AND": on.logical(lambda a, b: a and b),
        "OR": on.logical(lambda a, b: a or b),
        "XOR": on.logical(lambda a, b: a != b),
    }
    return on.lifted(apply, ranges[sign])


_LARGEST_EXPONENT = 709.782712893384
FUNCTIONS = {
    name: on.lifted(function(name), ranges, 1)
    for name, ranges in {
        "ABS": on.magnitude,
        "ACOS": on.falling(function("ACOS"), -1.0, 1.0),
        "ASIN": on.rising(function("ASIN"), -1.0, 1.0),
        "COS": on.within(-1.0, 1.0),
        "EXP": on.rising(function("EXP"), -math.inf, _LARGEST_EXPONENT, 0.0),
        "FIX": on.rounded(function("FIX")),
        "FUP": on.rounded(function("FUP")),
        "LN": on.rising(function("LN"), math.nextafter(0.0, 1.0), math.inf),
        "ROUND": on.rounded(function("ROUND")),
        "SIN": on.within(-1.0, 1.0),
        "SQRT": on.rising(function("SQRT"), 0.0, math.inf, 0.0),
        "TAN": on.within(-math.inf, math.inf),
    }.items()
}
_MAY_REFUSE = frozenset(FUNCTIONS[name] for name in ("ACOS", "ASIN", "EXP", "LN", "SQRT"))
ATAN = on.lifted(atan, on.within(-180.0, 180.0))
