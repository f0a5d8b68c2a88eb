"""What the fields of an advanced line of Z32 do, as nodes of a graph: assignments, IF, EB, jumps, calls, CP and PC (spec/z32.md §6.2 to §6.4). Knows no other line but through its builder."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, TypeVar

from deburr.arithmetic.z32 import integer, shown, to_cartesian, to_polar
from deburr.finding import Severity
from deburr.values import operations as on
from deburr.values.domain import Value, between, exactly
from deburr.values.graph import Calls, Dead, Env, Flows
from deburr.values.z32.conditions import decision
from deburr.values.z32.expressions import Expressions, Unread
from deburr.values.z32.storing import put
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.values.z32.flow import Builder, Site
    from deburr.values.z32.lines import Taken
    from deburr.values.z32.made import Bind

T = TypeVar("T")
_PLAIN = frozenset(("NUMBER", "NAME", "other", "vector", "unary"))
"""Sides of a condition that calculate nothing: what they ask for is not whether something comes out even."""
_SKEWED = 1 + 1e-12
"""What a radius may be off by."""


class Fields:
    """The fields of one line."""

    def __init__(self, builder: Builder, at: int, line: Taken) -> None:
        self._builder = builder
        self._at = at
        self._line = line
        self._made = builder.made(at)
        self._text = self._made.text
        self._groups = self._made.groups
        self._behind = builder.behind(at)
        self._left = builder.leaving(at)
        self._conditions: list[tuple[int, Node]] = []
        """The IFs, with their nodes, that hold where a field of the same group is reached."""

    def add(self) -> None:
        """Take each field in as a node."""
        number = self._builder.first(self._at)
        if not self._groups:
            self._going_on(number, Expressions(self._text, self._builder.world), None)
        last = number + self._made.fields
        for fields in self._groups:
            over = number + len(fields)
            self._conditions = []
            for field in fields:
                following = number + 1 if number + 1 < last else None
                self._field(field, number, following, over if over < last else None)
                number += 1

    def _field(self, field: Node, number: int, following: int | None, over: int | None) -> None:
        match field.kind:
            case "if":
                self._decide(field, number, following, over)
            case "assign":
                self._assign(field, number, following)
            case "jump":
                self._jump(field, number, self._expressions())
            case "call" | "file_call":
                self._call(field, number, self._expressions())
            case "polar":
                self._polar(field, number, self._expressions(), following)
            case "stop":
                self._going_on(number, self._expressions(), None)
            case _:
                raise Unread

    def _expressions(self) -> Expressions:
        return Expressions(self._text, self._builder.world)

    def _part(self, number: int, make: Callable[[Expressions], Bind[T]]) -> tuple[Expressions, T]:
        """What is made of a field, which is the same wherever a line says the same."""
        return self._made.part(number - self._builder.first(self._at), make)

    def _place(self, to: int | None) -> int | None:
        """The node where a way goes on; None where that hangs on the returns that wait."""
        return to if to is not None else None if self._builder.is_end(self._at) else self._behind

    def _flows(self, env: Env, to: int | None) -> Flows:
        """On to another field of the line, or out of it."""
        return self._left(self._behind, env) if to is None else ((to, env),)

    def _ways(self, *to: int | None) -> set[int]:
        inside = {each for each in to if each is not None}
        return inside if None not in to else inside | self._builder.exits(self._at, [self._behind])

    def _going_on(self, number: int, expressions: Expressions, to: int | None) -> None:
        ways = self._ways(to)
        self._builder.add(number, self._at, lambda env, calls: self._flows(env, to), expressions, ways, sure=True)

    def _decide(self, field: Node, number: int, then: int | None, otherwise: int | None) -> None:
        comparison = field.children[1]
        assert isinstance(comparison, Node)
        expressions, decide = self._part(number, lambda found: decision(comparison, found))
        self._conditions.append((number, field))
        places = self._place(then), self._place(otherwise)

        def decided(env: Env, calls: Calls) -> Flows:
            flows: list[tuple[int, Env]] = []
            for to, learned in zip(places, decide(env)):
                if learned is not None:
                    flows += self._flows(learned, None) if to is None else ((to, learned),)
            return flows

        span, ways = self._text.span(comparison), self._ways(then, otherwise)
        dead = self._idle(field, span, then, otherwise) if expressions.used else ()
        self._builder.add(number, self._at, decided, expressions, ways, condition=span, dead=dead)

    def _idle(self, field: Node, span: Span, then: int | None, otherwise: int | None) -> tuple[Dead, ...]:
        """What is said of a condition that decides nothing. One that jumps to the end of the program guards against what ought not to be."""
        if then is None or then == otherwise or self._builder.is_end(self._at):
            return ()
        fields = next(group for group in self._groups if field in group)
        jump = next((each for each in fields[fields.index(field) + 1 :] if each.kind == "jump"), None)
        rows = self._rows(jump) if jump is not None else ()
        comparison = field.children[1]
        assert isinstance(comparison, Node)
        said = self._text.said(comparison)
        if rows and jump is not None and jump.node("range_end") is None and rows[0] <= self._at:
            message = f"`{said}` never holds here, so that the loop makes one pass only"
            return (Dead(then, "loop-idle", span, message),)
        always = Dead(
            self._behind if otherwise is None else otherwise,
            "condition-constant",
            span,
            f"`{said}` always holds here",
            Severity.INFO,
        )
        plain = all(part.kind in _PLAIN for part in (comparison.children[0], comparison.children[-1]))
        message = f"`{said}` never holds here, so that what hangs on it is never run"
        never = Dead(then, "condition-constant", span, message)
        guards = bool(rows) and self._builder.only_stops(rows[0])
        return (*(() if guards else (never,)), *((always,) if plain else ()))

    def _rows(self, jump: Node) -> Sequence[int]:
        """The lines to which a jump leads."""
        part = jump.children[1]
        value = self._text.constant(part)
        return self._builder.targets(self._at, value, part.kind == "angle") if value is not None else ()

    def _assign(self, field: Node, number: int, to: int | None) -> None:
        target, value = field.children[0], field.children[2]
        expressions, change = self._part(number, lambda found: found.in_turn([found.assigned(target, value)]))
        ways, place = self._ways(to), self._place(to)
        sure = isinstance(target, Token) and isinstance(value, Token)
        if place is not None:
            self._builder.add_change(number, self._at, place, change, expressions, ways, sure=sure)
        else:
            self._builder.add(
                number, self._at, lambda env, calls: self._flows(change(env), None), expressions, ways, sure=sure
            )

    def _jump(self, field: Node, number: int, expressions: Expressions) -> None:
        part, builder = field.children[1], self._builder
        value = self._text.constant(part)
        ranged, site = field.node("range_end") is not None, builder.site(self._at, field)
        if ranged and site is None:
            self._lost(number, expressions)
            return

        dead = self._return(site, field) if site is not None else ()

        def sent(env: Env, to: int) -> Flows:
            return ((to, builder.pushed(env, site)),) if site is not None else self._left(to, env)

        if value is not None:
            rows = builder.targets(self._at, value, part.kind == "angle")
            if len(rows) != 1:
                self._lost(number, expressions)
                return
            to = builder.first(rows[0])
            ways = {to} if ranged else builder.exits(self._at, [to])
            builder.add(number, self._at, lambda env, calls: sent(env, to), expressions, ways, dead=dead, sure=True)
            if rows[0] <= self._at and not ranged and self._conditions:
                test, condition = self._conditions[-1]
                builder.back(number, to, test, Span(self._text.span(condition).start, self._text.span(field).end))
            return
        get = expressions.value(part)

        def computed(env: Env, calls: Calls) -> Flows:
            value = get(env)
            found = builder.labelled(value)
            if not found and not value.empty:
                said = f"N{shown(value.low)}" if value.exact else f"any of the values of `{expressions.said(part)}`"
                message = f"no block has the number {said}, so the control stops at this jump"
                raise expressions.proof("jump-target-missing", part, message)
            expressions.doubtful = expressions.doubtful or not value.exact
            rows = [builder.targets(self._at, each, True) for each in found]
            expressions.doubtful = expressions.doubtful or any(len(each) != 1 for each in rows)
            return [flow for each in rows if len(each) == 1 for flow in sent(env, builder.first(each[0]))]

        everywhere = [builder.first(at) for at, line in enumerate(builder.lines) if line.label is not None]
        builder.add(number, self._at, computed, expressions, builder.exits(self._at, everywhere), dead=dead)

    def _return(self, site: Site, field: Node) -> tuple[Dead, ...]:
        """Where a range comes back; what is said of a jump that never does."""
        last, behind = field.node("range_end"), self._behind
        assert last is not None, "a site has a range"
        passing = Expressions(self._text, self._builder.world)
        self._builder.add(site.returns, self._at, lambda env, calls: ((behind, env),), passing, (behind,))
        start, end = (self._text.said(part).lstrip("- \t") for part in (field.children[1], last))
        span = self._text.span(last)
        message = f"on every way from N{start} the program ends before it comes to {end}, so this jump never returns"
        return (Dead(site.returns, "range-open-at-end", Span(span.start + 1, span.end), message, later=True),)

    def _lost(self, number: int, expressions: Expressions) -> None:
        """A jump to a block that is not there, or is there twice: the control stops, and other rules say so."""

        def stopped(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            return ()

        self._builder.add(number, self._at, stopped, expressions, ())

    def _call(self, field: Node, number: int, expressions: Expressions) -> None:
        builder, part = self._builder, field.children[1]
        name = builder.called[self._line.node.text, self._text.span(field).start]
        builder.callees.add(name)
        known = field.kind == "file_call" or self._text.constant(part) is not None
        number_of = None if known else expressions.value(part)

        def called(env: Env, calls: Calls) -> Flows:
            if number_of is not None:
                self._judge_number(part, number_of(env), expressions)
            shared: Env = {key: value for key, value in env.items() if isinstance(key, str)}
            found = calls.call(name, {}, shared)
            expressions.doubtful = True
            if found is None:
                return self._flows({key: value for key, value in env.items() if not isinstance(key, str)}, None)
            if found.env is None:
                return ()
            written = found.written
            left = {
                k: v for k, v in env.items() if not isinstance(k, str) or (written is not None and k not in written)
            }
            given: Env = {k: v for k, v in found.env.items() if isinstance(k, str)}
            return self._flows({**left, **given}, None)

        ways = self._ways(None)
        builder.add(number, self._at, called, expressions, ways, callee=name, calls=True)

    def _judge_number(self, part: Node | Token, value: Value, expressions: Expressions) -> None:
        if value.exact and integer(value.low) is None:
            message = (
                f"there is no program {shown(value.low)}: the number of a program is an integer; the control stops here"
            )
            raise expressions.proof("program-number", part, message)

    def _polar(self, field: Node, number: int, expressions: Expressions, to: int | None) -> None:
        """CP and PC calculate with HX, HY, HR and HT."""
        part = field.children[0]
        turns = self._text.said(part).upper() == "CP"
        read, set_ = (("HX", "HY"), ("HR", "HT")) if turns else (("HR", "HT"), ("HX", "HY"))
        one, two = (expressions.read(name) for name in read)
        expressions.sets |= set(set_)

        def converted(env: Env, calls: Calls) -> Flows:
            a, b = one(env), two(env)
            found = self._to_polar(a, b, part, expressions) if turns else _to_cartesian(a, b)
            for name, value in zip(set_, found):
                env = put(env, name, value)
            return self._flows(env, to)

        self._builder.add(number, self._at, converted, expressions, self._ways(to))

    def _to_polar(self, x: Value, y: Value, part: Node | Token, expressions: Expressions) -> Iterable[Value]:
        if not x.exact or not y.exact:
            most = [max(-value.low, value.high) for value in (x, y)]
            least = max(0.0, *(max(value.low, -value.high) for value in (x, y)))
            about = between(least / _SKEWED, math.hypot(*most) * _SKEWED)
            expressions.doubtful = expressions.doubtful or about.wild
            return about._replace(wild=False), Value(-180.0, 180.0)
        radius, angle = to_polar(x.low, y.low)
        said = expressions.said(part)
        if math.isinf(radius):
            message = f"`{said}` has a result beyond the largest number here; the control stops"
            raise expressions.proof("domain", part, message)
        if radius == 0:
            message = f"`{said}` finds HX and HY at 0, where there is no angle; HR and HT become 0"
            expressions.remarks.append(expressions.proof("polar-origin", part, message))
        return exactly(radius), exactly(angle)


def _to_cartesian(radius: Value, angle: Value) -> Iterable[Value]:
    if radius.exact and angle.exact:
        return map(exactly, to_cartesian(radius.low, angle.low))
    found = on.times(radius, Value(-1.0, 1.0))._replace(wild=False)
    return found, found
