"""The values of a line as closures, made once: expressions, parameters, and what is stored (spec/z32.md §4, §5). Emits nothing."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from deburr.arithmetic import Refusal
from deburr.arithmetic.z32 import function, integer, nearest, operation, shown
from deburr.expand.z32.state import LAST, MACHINE, Place
from deburr.expand.z32.written import DECIMALS, DIGITS, written
from deburr.suggest import suggestion
from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.z32.state import State
    from deburr.fault import Halt

Get = Callable[[], float]


class Values:
    """Compiles the values of one line."""

    def __init__(self, state: State, file: str, row: int, text: str) -> None:
        self._state = state
        self._file = file
        self._row = row
        self._text = text
        decimals = state.job.inputs.decimals
        self._decimals = DECIMALS if decimals is None else decimals

    def value(self, part: Node | Token) -> Get:
        """What calculates a value."""
        if isinstance(part, Token):
            return self._token(part)
        match part.kind:
            case "angle" | "group":
                return self.value(part.children[1])
            case "signed" | "unary":
                get = self.value(part.children[1])
                return get if self._text[part.start] == "+" else lambda: -get()
            case "sum" | "product":
                return self._chain(part)
            case "function":
                return self._function(part)
            case "vector":
                return self._element(part)
            case "alias_name":
                return self._aliased(part)
            case _:
                return self.read(self.name(part), part)

    def store(self, target: Node | Token, part: Node | Token) -> Get:
        """What calculates a value, stores it, and gives it."""
        get, params = self.value(part), self._state.params
        if isinstance(target, Node) and target.kind == "vector":
            return self._store_element(target, part, get)
        if target.kind == "alias_name":
            axis = self.axis(target)

            def stored_in_axis() -> float:
                name = axis()
                value = params[name] = get()
                return value

            return stored_in_axis
        name = self.name(target)

        def stored() -> float:
            value = params[name] = get()
            return value

        return stored

    def name(self, target: Node | Token) -> str:
        """The name of a parameter that has letters and no alias."""
        return self.said(target).upper()

    def axis(self, part: Node | Token) -> Callable[[], str]:
        """The axis for which AA, AB or AC stands."""
        state, number_of_axis = self._state, "ABC".index(self.said(part)[1].upper())

        def found() -> str:
            if not state.alias:
                raise self._unaliased(part)
            return state.alias[number_of_axis]

        return found

    def read(self, name: str, part: Node | Token) -> Get:
        """The value of a parameter by its name; a fault is said at ``part``."""
        params = self._state.params

        def found() -> float:
            try:
                return params[name]
            except KeyError:
                raise self._unset(name, part) from None

        return found

    def printed(self, get: Get, part: Node | Token) -> Callable[[], str]:
        """A value as it is written in the flat program."""
        decimals = self._decimals

        def found() -> str:
            value = get()
            text = written(value, decimals)
            if text is None:
                message = f"`{self.said(part)}` is {value:.0f} here; the control takes no more than {DIGITS} digits"
                raise self.halt("number-digits", part, message)
            return text

        return found

    def integer(self, part: Node | Token, get: Get, kind: str, message: str) -> Callable[[], int]:
        """A value that must be an integer; in the message, `{}` is its value."""

        def found() -> int:
            value = get()
            whole = integer(value)
            if whole is None:
                raise self.halt(kind, part, message.format(shown(value)))
            return whole

        return found

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        return self._text[part.start : part.end]

    def place(self, part: Node | Token) -> Place:
        """Where a part stands."""
        return Place(self._file, self._row, Span(part.start, part.end))

    def halt(self, kind: str, part: Node | Token, message: str, unsure: bool = False) -> Halt:
        """The end of the run at a part of this line."""
        return self._state.fault(kind, self.place(part), message, unsure)

    def _token(self, part: Token) -> Get:
        if part.kind not in ("NUMBER", "PI"):
            return self.read(self.name(part), part)
        value = math.pi if part.kind == "PI" else number(self.said(part))
        return lambda: value

    def _chain(self, part: Node) -> Get:
        """Terms or factors from left to right; one loop, however many there are."""
        signs = [self._text[sign.start] for sign in part.children[1::2]]
        first, *others = [self.value(child) for child in part.children[::2]]
        rest = list(zip(map(operation, signs), others, part.children[2::2]))
        if len(rest) == 1:
            return self._pair(part, *rest[0][:2], first)

        def found() -> float:
            value = first()
            for apply, get, child in rest:
                try:
                    value = apply(value, get())
                except Refusal as refused:
                    raise self._refused(refused, part, child) from None
            return value

        return found

    def _pair(self, part: Node, apply: Callable[[float, float], float], second: Get, first: Get) -> Get:
        def found() -> float:
            try:
                return apply(first(), second())
            except Refusal as refused:
                raise self._refused(refused, part, part.children[2]) from None

        return found

    def _function(self, part: Node) -> Get:
        apply, get = function(self.said(part.children[0]).upper()), self.value(part.children[2])

        def found() -> float:
            try:
                return apply(get())
            except Refusal as refused:
                raise self._refused(refused, part, part) from None

        return found

    def _refused(self, refused: Refusal, part: Node, divisor: Node | Token) -> Halt:
        if refused.rule == "divide-by-zero":
            message = f"`{self.said(divisor)}` is 0 here; the control stops at a division by zero"
            return self.halt(refused.rule, divisor, message)
        return self.halt(refused.rule, part, f"`{self.said(part)}` is {refused.why} here; the control stops")

    def _aliased(self, part: Node | Token) -> Get:
        axis, params = self.axis(part), self._state.params

        def found() -> float:
            name = axis()
            try:
                return params[name]
            except KeyError:
                raise self._unset(name, part) from None

        return found

    def _element(self, vector: Node) -> Get:
        is_pal = self._is_pal(vector)
        values, index = self._state.pal if is_pal else self._state.par, self._index(vector)

        def found() -> float:
            at = index()
            value = values[at]
            if value is None:
                raise self._unset_element(is_pal, at, vector)
            return value

        return found

    def _store_element(self, vector: Node, part: Node | Token, get: Get) -> Get:
        index, par, pal = self._index(vector), self._state.par, self._state.pal
        if not self._is_pal(vector):

            def stored() -> float:
                at = index()
                value = par[at] = get()
                return value

            return stored

        def stored_rounded() -> float:
            at = index()
            if at >= MACHINE:
                message = f"`{self.said(vector)}` is PAL[{at}] here, which is written by the machine only; the control stops, PAL[0] to PAL[255] are free"
                raise self.halt("pal-read-only", vector, message)
            value = get()
            whole = pal[at] = value if value.is_integer() else nearest(value)
            if whole != value:
                message = f"`{self.said(part)}` is {shown(value)} here; PAL holds integers, so {shown(whole)} is stored, PAR keeps decimals"
                self._state.warn("pal-rounded", self.place(part), message)
            return whole

        return stored_rounded

    def _is_pal(self, vector: Node) -> bool:
        return self.said(vector)[:3].upper() == "PAL"

    def _index(self, vector: Node) -> Callable[[], int]:
        part = vector.children[2]
        message = f"the index of `{self.said(vector)}` is {{}} here, which is no integer; `NEI(...)` or `INT(...)` makes it one"
        get = self.integer(part, self.value(part), "index-not-integer", message)
        if isinstance(part, Token) and part.kind == "NUMBER":
            literal = integer(number(self.said(part)))
            if literal is not None and 0 <= literal <= LAST:
                return lambda: literal

        def found() -> int:
            at = get()
            if not 0 <= at <= LAST:
                message = f"`{self.said(vector)}` does not exist: the index goes from 0 to {LAST}, this one is {shown(at)} here"
                raise self.halt("index-range", part, message)
            return at

        return found

    def _unset(self, name: str, part: Node | Token) -> Halt:
        ways = self._state.job.inputs.ways
        given = ways.define.format(f"{name}=...")
        if name in self._state.uncertain:
            message = f"`{name}` was last set on an optional line, so its value depends on the operator's switch; say {ways.switch}"
        elif name in self._state.axes:
            message = f"no word for the axis `{name}` has been run yet, so its value depends on where the machine stands; program it before, or say {given}"
        else:
            message = f"`{name}` has no value yet, so what it holds depends on what ran before; set it first, or say {given}{suggestion(name, self._state.params)}"
        return self.halt("read-before-set", part, message)

    def _unset_element(self, is_pal: bool, at: int, vector: Node) -> Halt:
        name = f"PA{'L' if is_pal else 'R'}[{at}]"
        given = self._state.job.inputs.ways.define.format(f"{name}=...")
        if is_pal and at >= MACHINE:
            message = f"`{name}` is written by the machine, and no value is given for it; the setting `pal` or {given} gives one"
            return self.halt("pal-machine-value", vector, message)
        message = (
            f"`{name}` has no value yet, so what it holds depends on what ran before; set it first, or say {given}"
        )
        return self.halt("read-before-set", vector, message)

    def _unaliased(self, part: Node | Token) -> Halt:
        message = f"`{self.said(part).upper()}` stands for no axis yet: `G25` must name three before"
        # A program that another one calls finds the axes that its caller named.
        return self.halt("alias-unset", part, message, not self._state.is_main)
