"""The values of a line as closures, made once: expressions, parameters, functions (spec/rs274.md §3, §4). Emits nothing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from deburr.arithmetic import Refusal
from deburr.arithmetic.rs274 import TOLERANCE, atan, function, number, operation, spelled
from deburr.expand.rs274.source import Source, Spot
from deburr.expand.rs274.state import READ_ONLY
from deburr.suggest import suggestion
from deburr_grammar.dialects.rs274.names import name_of
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.rs274.state import State
    from deburr.fault import Halt

Get = Callable[[], float]
Put = Callable[[float], None]
NEAR = 1e-4
"""How near to an integer a value must be where one is required (spec/rs274.md §1.2)."""
_MAY_BE_INFINITE = frozenset(("sum", "product", "quotient", "modulo", "power"))
_NEVER_REFUSED = frozenset(("sum", "product", "modulo", "logical"))
_OPERATIONS = frozenset(("sum", "product", "quotient", "modulo", "power", "comparison", "logical"))


class Numbers:
    """The literal numbers of a line that are arguments of what is compiled. ``places``: which number of the line starts in which column."""

    def __init__(self, places: Mapping[int, int]) -> None:
        self._places = places
        self.used: list[int] = []
        self.values: list[float] = []
        """Of the line at hand, those that are used."""

    def add(self, column: int) -> int:
        """Use the number in a column; where its value will stand."""
        self.used.append(self._places[column])
        return len(self.used) - 1


class Values:
    """Compiles the values of one line, or of all lines that differ only in numbers."""

    def __init__(self, state: State, source: Source, numbers: Numbers | None = None) -> None:
        """``numbers``: those that differ among the lines for which the values are compiled."""
        self._state = state
        self._source = source
        self._numbers = numbers
        self._near = TOLERANCE[state.job.settings["compare"]]
        self._begun: set[str] = set()
        """Names that are set further to the left on the line: the control has made them, without a value."""

    def value(self, part: Node | Token) -> Get:
        """What calculates a value."""
        if isinstance(part, Token):
            return self._literal(part)
        if part.kind in _OPERATIONS:
            return self._operation(part)
        match part.kind:
            case "signed":
                inner = self.value(part.children[1])
                return inner if self._source.sample[part.start] == "+" else lambda: -inner()
            case "param":
                return self._read(part)
            case "function":
                return self._one(
                    part, function(spelled(self._source.sample, part.children[0])), self.value(part.children[1])
                )
            case "atan":
                return self._two(part, atan, self.value(part.children[1]), self.value(part.children[3]))
            case "exists":
                return self._exists(part)
            case "group":
                return self._group(part)
            case _:
                return self.value(part.children[0])

    def integer(self, part: Node | Token, rule: str = "integer-required") -> Callable[[], int]:
        """A value that must be near an integer."""
        return self._nearest(part, self.value(part), rule)

    def _nearest(self, part: Node | Token, get: Get, rule: str) -> Callable[[], int]:
        def found() -> int:
            value = get()
            nearest = round(value)
            if abs(value - nearest) > NEAR:
                raise self.halt(rule, part, f"`{self.said(part)}` is {value:g} here, and must be an integer")
            return nearest

        return found

    def setter(self, param: Node) -> Callable[[], Put]:
        """What finds out, while the line is read, which parameter it sets; what that gives sets it when all is read."""
        name = self.name(param)
        if name is not None:
            self._begun.add(name)
            return lambda: self._put_named(name, param)
        index = self._index(param)
        params = self._state.params

        def found() -> Put:
            at = index()
            if at in READ_ONLY:
                raise self.halt("param-readonly", param, f"`{self.said(param)}` is #{at} here, which is read-only")

            def put(value: float) -> None:
                params[at] = value
                self._state.machine.written(at)

            return put

        return found

    def name(self, param: Node) -> str | None:
        """The name of a named parameter as the control compares it; None for a numbered one."""
        said = param.children[1]
        return name_of(self.said(said)) if said.kind == "NAME" else None

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        return self._source.said(part)

    def halt(self, kind: str, part: Node | Token, message: str) -> Halt:
        """The end of the run at a part of this line."""
        return self._state.fault(kind, self._source.file, self._source.row, self._source.span(part), message)

    def _literal(self, part: Token) -> Get:
        if self._numbers is not None:
            values, at = self._numbers.values, self._numbers.add(part.start)
            return lambda: values[at]
        literal = number(self.said(part))
        return lambda: literal

    def _group(self, part: Node) -> Get:
        """Brackets: what they give must be a finite number."""
        inner = part.children[1]
        get = self.value(inner)
        if not isinstance(inner, Node) or inner.kind not in _MAY_BE_INFINITE:
            return get

        def found() -> float:
            value = get()
            if value - value == 0:
                return value
            raise self.halt(
                "not-finite", part, f"`{self.said(part)}` is a result that is no finite number; the control stops here"
            )

        return found

    def _operation(self, part: Node) -> Get:
        left, sign, right = part.children
        operator = spelled(self._source.sample, sign)
        a, b = self.value(left), self.value(right)
        apply = operation(operator, self._near)
        if part.kind == "comparison":
            return self._compared(part, operator, apply, a, b)
        if part.kind in _NEVER_REFUSED:
            return lambda: apply(a(), b())
        return self._two(part, apply, a, b)

    def _two(self, part: Node, apply: Callable[[float, float], float], a: Get, b: Get) -> Get:
        def found() -> float:
            try:
                return apply(a(), b())
            except Refusal as refused:
                raise self._refused(part, refused) from None

        return found

    def _one(self, part: Node, apply: Callable[[float], float], a: Get) -> Get:
        def found() -> float:
            try:
                return apply(a())
            except Refusal as refused:
                raise self._refused(part, refused) from None

        return found

    def _refused(self, part: Node, refused: Refusal) -> Halt:
        at = part.children[2] if refused.rule == "divide-by-zero" else part
        return self.halt(refused.rule, at, f"`{self.said(part)}` is {refused.why}; the control stops here")

    def _compared(self, part: Node, operator: str, apply: Callable[[float, float], float], a: Get, b: Get) -> Get:
        """A comparison; where controls of another version decide it otherwise, that is said."""
        newer = operation(operator, TOLERANCE["1e-6"])
        older = operation(operator, TOLERANCE["1e-4"])

        def found() -> float:
            left, right = a(), b()
            if left != right and -1e-3 < left - right < 1e-3 and newer(left, right) != older(left, right):
                self._warn_near(part, left, right)
            return apply(left, right)

        return found

    def _warn_near(self, part: Node, left: float, right: float) -> None:
        message = f"`{self.said(part)}` compares {left!r} with {right!r}: controls before and from LinuxCNC 2.9 decide it differently"
        self._state.warn("compare-near", self._source.file, self._source.row, self._source.span(part), message)

    def _exists(self, part: Node) -> Get:
        param = part.children[2]
        if not isinstance(param, Node) or param.kind != "param":
            raise self.halt(
                "exists-argument", part, f"`{self.said(part)}` asks for no parameter; the control stops here"
            )
        name = self.name(param)
        if name is None:
            index, last = self.integer(param.children[1]), self._state.last
            return lambda: 1.0 if 1 <= index() <= last else 0.0
        if self._state.machine.named(name) is not None:
            return lambda: 1.0
        if name in self._begun:
            return lambda: 1.0
        if name.startswith("_"):
            return lambda: 1.0 if name in self._state.globals else 0.0
        return lambda: 1.0 if name in self._state.locals else 0.0

    def _read(self, param: Node) -> Get:
        name = self.name(param)
        if name is not None:
            return self._read_named(param, name)
        read = self._state.machine.number
        params, special = self._state.params, self._state.machine.special
        spot = Spot(self._source, param)
        index = self._index(param)
        if isinstance(param.children[1], Token):
            at = index()
            if at not in special:
                return lambda: params[at]

        def found() -> float:
            at = index()
            return params[at] if at not in special else read(at, spot)

        return found

    def _index(self, param: Node) -> Callable[[], int]:
        said, last = param.children[1], self._state.last
        if isinstance(said, Token):
            # Lines that share what is compiled share the numbers of their parameters.
            value = number(self.said(said))
            index = self._nearest(said, lambda: value, "integer-required")
        else:
            index = self.integer(said)

        def found() -> int:
            at = index()
            if not 1 <= at <= last:
                raise self.halt(
                    "param-range", param, f"`{self.said(param)}` is parameter #{at} here; they go from 1 to {last}"
                )
            return at

        return found

    def _read_named(self, param: Node, name: str) -> Get:
        known = self._state.machine.named(name)
        if known is not None:
            spot = Spot(self._source, param)
            return lambda: known(spot)
        state = self._state
        is_global = name.startswith("_")
        begun = name in self._begun

        def found() -> float:
            value = (state.globals if is_global else state.locals).get(name)
            if value is None:
                if begun:
                    return 0.0
                raise self.halt("named-undefined", param, self._undefined(name))
            return value

        return found

    def _undefined(self, name: str) -> str:
        names = [*self._state.globals, *self._state.locals]
        if f"_{name}" in self._state.globals:
            return f"`#<{name}>` has no value here; the program sets `#<_{name}>`, which is another one"
        return f"`#<{name}>` has no value here; the control stops{suggestion(name, names)}"

    def _put_named(self, name: str, param: Node) -> Put:
        if self._state.machine.named(name) is not None:
            raise self.halt("param-readonly", param, f"`#<{name}>` is predefined and read-only")
        names = self._state.globals if name.startswith("_") else self._state.locals

        def put(value: float) -> None:
            names[name] = value

        return put
