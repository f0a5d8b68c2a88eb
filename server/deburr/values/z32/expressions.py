"""Z32's expressions on values as closures: the language's own operators and functions, on all that a parameter can hold (spec/z32.md §4, §5)."""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

from deburr.arithmetic import Refusal
from deburr.arithmetic.z32 import NEAR_INTEGER, function, integer, nearest, operation, shown
from deburr.values import operations as on
from deburr.values.domain import ANY, UNITS, Value, exactly, joined
from deburr.values.graph import Env, Proof
from deburr.values.remembered import Remembered, stored
from deburr.values.z32.lines import is_system
from deburr.values.z32.storing import Stored, put
from deburr.values.z32.text import Text
from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.tree import Node, Token

T = TypeVar("T")
Get = Callable[[Env], Value]
Put = Callable[[Env, Value], Env]
LAST, MACHINE = 512, 256
"""The last index of PAL and PAR, and the first one of PAL that belongs to the machine (spec/z32.md §5)."""
ALIAS = "G25"
"""The key of the axes for which AA, AB and AC stand."""
INTEGERS = Value(-math.inf, math.inf, UNITS)
"""Any integer: what PAL holds."""
_MOST = 40
"""Of so many elements the values are joined where one of them is meant."""
_PAL, _PAR = ([f"{name}[{at}]" for at in range(LAST + 1)] for name in ("PAL", "PAR"))
_NO_NUMBER = "a result beyond the largest number"


class Unread(Exception):
    """Inside this package: a line, or what stands on it, that the control cannot read."""


@dataclass(frozen=True, eq=False, slots=True)
class World:
    """What is the same for all lines of a program: the axis and system parameters that are followed, and the machine's values. One object for the same."""

    tracked: frozenset[str]
    machine: Mapping[int, float]

    @staticmethod
    @lru_cache(maxsize=256)
    def of(tracked: frozenset[str], machine: tuple[tuple[int, float], ...]) -> World:
        """The world of these parameters and values."""
        return World(tracked, dict(machine))


class Expressions:
    """Compiles the values of one part of the lines of a shape. ``used`` and ``sets``: the parameters that it reads and sets; None among them: who knows which.

    ``text``: of the line that is calculated now. Whoever calculates says which it is, because all lines of a shape may share what is compiled.
    """

    __slots__ = ("_reads", "_touched", "_world", "doubtful", "is_narrow", "literals", "remarks", "sets", "text", "used")

    def __init__(self, text: Text, world: World) -> None:
        self.text = text
        self._touched: tuple[frozenset[Hashable], frozenset[Hashable]] | None = None
        self._world = world
        self._reads = 0
        """How many places read something."""
        self.used: set[Hashable] = set()
        self.sets: set[Hashable] = set()
        self.literals: set[Hashable] = set()
        """The parameters that it sets to numbers that are written out, and to nothing else."""
        self.is_narrow = True
        """Whether all that it sets and says hangs on nothing but what it reads, and nothing can be remarked."""
        self.doubtful = False
        """Whether something may have failed since it was last set to False."""
        self.remarks: list[Proof] = []
        """What is certain and does not stop the control, since it was last emptied."""

    def touched(self) -> tuple[frozenset[Hashable], frozenset[Hashable]]:
        """All that it reads and all that it sets, when everything is compiled."""
        if self._touched is None:
            self._touched = frozenset(self.used), frozenset(self.sets)
        return self._touched

    def in_turn(self, steps: Sequence[Callable[[Env], Env]]) -> Callable[[Text], Callable[[Env], Env]]:
        """All of some steps, which are all that stands in this part of the line, for each line of the shape."""

        def taken(env: Env) -> Env:
            for step in steps:
                env = step(env)
            return env

        if not self.is_narrow:
            return lambda text: self.of(text, taken)
        if not steps:
            return lambda text: _unchanged
        keys = tuple(sorted(self.sets, key=str))
        only = steps[0] if len(steps) == 1 else None
        find = only.changes if isinstance(only, Stored) else lambda env: stored(taken(env), keys)

        def bound(text: Text) -> Callable[[Env], Env]:
            remembered = Remembered(self, self.of(text, find))
            return lambda env: remembered.of(env).on(env)

        return bound

    def of(self, text: Text, find: Callable[[Env], T]) -> Callable[[Env], T]:
        """The same, calculated with the numbers of one line."""

        def found(env: Env) -> T:
            self.text = text
            return find(env)

        return found

    def is_doubtful(self) -> bool:
        """Whether something may have failed when this was last calculated."""
        return self.doubtful

    def remark(self) -> Proof | None:
        """What was certain then and did not stop the control."""
        return self.remarks[0] if self.remarks else None

    def value(self, part: Node | Token) -> Get:
        """What calculates a value."""
        if isinstance(part, Token):
            return self._token(part)
        match part.kind:
            case "angle" | "group":
                return self.value(part.children[1])
            case "signed" | "unary":
                inner = self.value(part.children[1])
                return inner if self.said(part).startswith("+") else lambda env: on.negative(inner(env))
            case "sum" | "product":
                return self._chain(part)
            case "function":
                return self._function(part)
            case "vector":
                return self._element(part)
            case "alias_name":
                return self._aliased(part)
            case "other":
                return self.read(self.said(part).upper())
            case _:
                raise Unread

    def target(self, part: Node | Token) -> Put:
        """What stores a value."""
        if part.kind == "vector":
            assert isinstance(part, Node)
            return self._store_element(part)
        if part.kind == "alias_name":
            return self._store_aliased(part)
        if part.kind not in ("NAME", "M_END", "other"):
            raise Unread
        return self.store(self.said(part).upper())

    def assigned(self, target: Node | Token, part: Node | Token) -> Callable[[Env], Env]:
        """What calculates a value and stores it."""
        store, key = self.target(target), self.key(target)
        reads = self._reads
        get = self.value(part)
        if key is not None and self._reads == reads and self.text.constant(part) is not None:
            self.literals.add(key)
        if not isinstance(target, Node) or target.kind != "vector" or not self._is_pal(target):
            return Stored(key, get) if key is not None else lambda env: store(env, get(env))

        self.is_narrow = False

        def rounded(env: Env) -> Env:
            value = get(env)
            self._judge_rounding(part, value)
            return store(env, value)

        return rounded

    def is_followed(self, name: str) -> bool:
        """Whether anybody asks what a parameter holds."""
        return name in self._world.tracked or not is_system(name)

    def follows(self, target: Node | Token) -> bool:
        """Whether anybody asks what is stored there."""
        return isinstance(target, Node) or self.is_followed(self.said(target).upper())

    def store(self, name: str) -> Put:
        """What stores in a parameter by its name."""
        if not self.is_followed(name):
            return lambda env, value: env
        self.sets.add(name)
        return lambda env, value: put(env, name, value)

    def read(self, name: str) -> Get:
        """The value of a parameter by its name."""
        self._reads += 1
        if not self.is_followed(name):
            return lambda env: ANY
        self.used.add(name)
        return lambda env: env.get(name, ANY)

    def key(self, part: Node | Token) -> str | None:
        """The parameter that a part is, if the line alone tells which."""
        if part.kind in ("NAME", "other"):
            name = self.said(part).upper()
            return name if self.is_followed(name) else None
        if part.kind == "vector":
            assert isinstance(part, Node)
            at = self._literal(part)
            return None if at is None or (at >= MACHINE and self._is_pal(part)) else self._name(part, at)
        return None

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        return self.text.said(part)

    def proof(self, kind: str, part: Node | Token, message: str) -> Proof:
        """What is certain to go wrong at a part of this line."""
        return Proof(kind, self.text.span(part), message)

    def _token(self, part: Token) -> Get:
        if part.kind == "NAME":
            return self.read(self.said(part).upper())
        if part.kind not in ("NUMBER", "PI"):
            raise Unread
        if self.text.literal(part).empty:
            raise Unread
        start = part.start

        def literal(env: Env) -> Value:
            text = self.text
            return text.literals.get(start) or text.literal(part)

        return literal

    def _chain(self, part: Node) -> Get:
        """Terms or factors from left to right."""
        signs = [self.said(sign) for sign in part.children[1::2]]
        first, *others = [self.value(child) for child in part.children[::2]]
        operations = [_OPERATIONS[sign] for sign in signs]
        rest = list(zip(operations, [sign == "/" for sign in signs], others, part.children[2::2]))

        def found(env: Env) -> Value:
            value = first(env)
            for apply, divides, get, child in rest:
                other = get(env)
                try:
                    value = apply(value, other)
                    if value.wild:
                        value = self._finite(value)
                except Refusal as refused:
                    raise self._refused(refused, part, child) from None
                if divides and other.has(0.0) and not value.empty:
                    self.doubtful = True
            return value

        return found

    def _function(self, part: Node) -> Get:
        name, get = self.said(part.children[0]).upper(), self.value(part.children[2])
        apply, may_refuse = _FUNCTIONS[name], name in ("RQ", "TAN")

        def found(env: Env) -> Value:
            value = get(env)
            self.doubtful = self.doubtful or (may_refuse and not value.exact)
            try:
                value = apply(value)
                return self._finite(value) if value.wild else value
            except Refusal as refused:
                raise self._refused(refused, part, part) from None

        return found

    def _finite(self, value: Value) -> Value:
        self.doubtful = True
        return on.finite(value)

    def _refused(self, refused: Refusal, part: Node, divisor: Node | Token) -> Proof:
        if refused.rule == "divide-by-zero":
            message = f"`{self.said(divisor)}` is 0 here; the control stops at a division by zero"
            return self.proof(refused.rule, divisor, message)
        why = _NO_NUMBER if refused.rule == "not-finite" else refused.why
        return self.proof("domain", part, f"`{self.said(part)}` is {why} here; the control stops")

    def _aliased(self, part: Node | Token) -> Get:
        at = "ABC".index(self.said(part)[1].upper())
        self._reads += 1
        self.used |= {ALIAS, *(name for name in self._world.tracked if len(name) == 1)}

        def found(env: Env) -> Value:
            axes = axes_of(env)
            self.doubtful = self.doubtful or not axes
            return env.get(axes[at], ANY) if axes and axes[at] in self._world.tracked else ANY

        return found

    def _store_aliased(self, part: Node | Token) -> Put:
        at, tracked = "ABC".index(self.said(part)[1].upper()), self._world.tracked
        letters = frozenset(name for name in tracked if len(name) == 1)
        self.used.add(ALIAS)
        self.sets |= letters
        self.is_narrow = False

        def put_in(env: Env, value: Value) -> Env:
            axes = axes_of(env)
            if axes:
                return put(env, axes[at], value) if axes[at] in tracked else env
            self.doubtful = True
            return {key: old for key, old in env.items() if key not in letters}

        return put_in

    def _element(self, vector: Node) -> Get:
        is_pal, at = self._is_pal(vector), self._literal(vector)
        self._reads += 1
        self.used.add(None if at is None else self._name(vector, at))
        if at is not None and not (is_pal and at >= MACHINE):
            name, any_ = self._name(vector, at), INTEGERS if is_pal else ANY
            return lambda env: env.get(name, any_)
        index = self.index(vector)

        def found(env: Env) -> Value:
            value = index(env)
            if value.high - value.low > _MOST:
                return self._any(is_pal)
            first, last = _elements(value)
            held = [self._held(env, vector, is_pal, each) for each in range(first, last + 1) if _may_be(value, each)]
            return on.union(held) if held else self._any(is_pal)

        return found

    def _any(self, is_pal: bool) -> Value:
        return INTEGERS if is_pal and all(value.is_integer() for value in self._world.machine.values()) else ANY

    def _held(self, env: Env, vector: Node, is_pal: bool, at: int) -> Value:
        if not is_pal:
            return env.get(self._name(vector, at), ANY)
        if at >= MACHINE:
            given = self._world.machine.get(at)
            self.doubtful = self.doubtful or given is None
            return INTEGERS if given is None else exactly(given)
        return env.get(self._name(vector, at), INTEGERS)

    def _store_element(self, vector: Node) -> Put:
        is_pal, literal = self._is_pal(vector), self._literal(vector)
        self.sets.add(None if literal is None else self._name(vector, literal))
        if literal is not None and not (is_pal and literal >= MACHINE):
            name = self._name(vector, literal)
            return lambda env, value: put(env, name, _ROUNDED(value) if is_pal else value)
        self.is_narrow = False
        index = self.index(vector)
        names: list[Hashable] = list(_PAL if is_pal else _PAR)

        def put_in(env: Env, value: Value) -> Env:
            at = index(env)
            if is_pal:
                self._judge_writable(vector, at)
                at = at._replace(high=min(at.high, float(MACHINE - 1)))
                value = _ROUNDED(value)
            first, last = _elements(at)
            if first == last:
                return put(env, str(names[first]), value)
            inside = dict(zip(names[first : last + 1], range(first, last + 1)))
            changed: Env = {
                key: joined(old, value) for key, old in env.items() if key in inside and _may_be(at, inside[key])
            }
            return {**env, **changed}

        return put_in

    def _judge_writable(self, vector: Node, at: Value) -> None:
        if at.low > MACHINE - 0.5:
            which = f"PAL[{round(at.low)}]" if at.exact else f"PAL[{MACHINE}] or above"
            message = f"`{self.said(vector)}` is {which} here, which is written by the machine only; the control stops, PAL[0] to PAL[255] are free"
            raise self.proof("pal-read-only", vector, message)
        self.doubtful = self.doubtful or at.high > MACHINE - 0.5

    def _judge_rounding(self, part: Node | Token, value: Value) -> None:
        """Remark that a value with decimals is stored in PAL, which keeps integers."""
        if value.empty:
            return
        if value.exact and not value.low.is_integer():
            message = f"`{self.said(part)}` is {shown(value.low)} here; PAL holds integers, so {shown(nearest(value.low))} is stored, PAR keeps decimals"
        elif value.step and value.step % UNITS == 0 and math.isfinite(value.low) and not value.low.is_integer():
            message = f"`{self.said(part)}` is never an integer here; PAL holds integers, so it is rounded, PAR keeps decimals"
        else:
            return
        self.remarks.append(self.proof("pal-rounded", part, message))

    def index(self, vector: Node) -> Get:
        """What calculates an index; it must be an integer, and one that there is."""
        part = vector.children[2]
        get = self.value(part)

        def found(env: Env) -> Value:
            value = get(env)
            if value.exact:
                return exactly(float(self._exact_index(vector, part, value.low)))
            if value.whole and (value.high < 0 or value.low > LAST):
                which = "below 0" if value.high < 0 else f"above {LAST}"
                message = f"`{self.said(vector)}` does not exist: the index goes from 0 to {LAST}, this one is always {which} here"
                raise self.proof("index-range", part, message)
            self.doubtful = self.doubtful or not (value.whole and value.low >= 0 and value.high <= LAST)
            return value

        return found

    def _exact_index(self, vector: Node, part: Node | Token, value: float) -> int:
        at = integer(value)
        if at is None:
            message = f"the index of `{self.said(vector)}` is {shown(value)} here, which is no integer; `NEI(...)` or `INT(...)` makes it one"
            raise self.proof("index-not-integer", part, message)
        if not 0 <= at <= LAST:
            message = f"`{self.said(vector)}` does not exist: the index goes from 0 to {LAST}, this one is {at} here"
            raise self.proof("index-range", part, message)
        return at

    def _literal(self, vector: Node) -> int | None:
        """The index of an element that is written out."""
        part = vector.children[2]
        if not isinstance(part, Token) or part.kind != "NUMBER":
            return None
        at = integer(number(self.said(part))) if len(self.said(part)) < 10 else None
        return at if at is not None and at <= LAST else None

    def _is_pal(self, vector: Node) -> bool:
        return self.said(vector)[:3].upper() == "PAL"

    def _name(self, vector: Node, at: int) -> str:
        return (_PAL if self._is_pal(vector) else _PAR)[at]


def _unchanged(env: Env) -> Env:
    return env


def axes_of(env: Env) -> str:
    """The axes for which AA, AB and AC stand; empty where that is not known."""
    value = env.get(ALIAS, ANY)
    return int(value.low).to_bytes(3, "big").decode("ascii") if value.exact else ""


def named(axes: str) -> Value:
    """Three axes as a value."""
    return exactly(float(int.from_bytes(axes.encode("ascii"), "big")))


def _elements(value: Value) -> tuple[int, int]:
    """The first and the last element that an index may mean."""
    return math.ceil(max(0.0, value.low - 0.5)), math.floor(min(float(LAST), value.high + 0.5))


def _may_be(value: Value, at: int) -> bool:
    """Whether an index may be meant: a value that is nearly an integer counts as that."""
    near = value.low - NEAR_INTEGER <= at <= value.high + NEAR_INTEGER
    return near and (not value.whole or value.has(float(at)))


_OPERATIONS = {
    sign: on.lifted(operation(sign), ranges)
    for sign, ranges in {"+": on.plus, "-": on.minus, "*": on.times, "/": on.divided(operation("/"))}.items()
}
_FUNCTIONS = {
    name: on.lifted(function(name), ranges, 1)
    for name, ranges in {
        "SN": on.within(-1.0, 1.0),
        "CS": on.within(-1.0, 1.0),
        "TAN": on.within(-math.inf, math.inf),
        "AT": on.within(-90.0, 90.0),
        "ABS": on.magnitude,
        "INT": on.rounded(function("INT")),
        "NEI": on.rounded(function("NEI")),
        "RQ": on.rising(function("RQ"), 0.0, math.inf, 0.0),
    }.items()
}
_ROUNDED = _FUNCTIONS["NEI"]
