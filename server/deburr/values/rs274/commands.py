"""What RS274's lines do, as nodes of a graph: settings and words, branches, loops, calls, returns (spec/rs274.md §4.3, §6). Knows no other line but through its block."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING

from deburr.arithmetic.rs274 import TOLERANCE
from deburr.finding import Severity
from deburr.values.domain import NO
from deburr.values.graph import RETURN, STOP, Calls, Dead, Env, Flows, Loop, Proof
from deburr.values.rs274.conditions import Conditions
from deburr.values.rs274.expressions import ARGUMENTS, NEAR, Expressions
from deburr.values.rs274.keys import ANYTHING, UNSEEN, is_shared, put, set_by
from deburr.values.rs274.lines import aborts
from deburr_grammar.text import Span
from deburr_grammar.tree import Node as Part
from deburr_grammar.tree import walk

if TYPE_CHECKING:
    from deburr.values.rs274.conditions import Learn
    from deburr.values.rs274.expressions import Get
    from deburr.values.rs274.flow import Builder
    from deburr.values.rs274.lines import Taken


CONSTANT = "condition-constant"


class Torn(Exception):
    """Inside this package: nothing can be said of the program, because its flow hangs on what nobody can see."""


class Block:
    """A block: what opens it, and the positions of its lines in the routine."""

    def __init__(self, kind: str, label: str | None, first: int) -> None:
        self.kind = kind
        self.label = label
        self.first = first
        self.middles: list[int] = []
        self.last = first


class Commands:
    """What the lines do: one of them."""

    def __init__(self, builder: Builder, at: int, line: Taken, expressions: Expressions) -> None:
        self._builder = builder
        self._at = at
        self._line = line
        self._expressions = expressions
        self._o_line = next(line.node.find("o_line"), None)
        self._groups = (
            [part for part in self._o_line.nodes() if part.kind == "group"] if self._o_line is not None else []
        )

    def unread(self) -> None:
        """A line that cannot be read: the control stops there, or whoever mends it may set anything."""
        expressions, behind = self._expressions, self._builder.behind(self._at)

        def passed(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            return ((behind, {}),)

        expressions.used.add(None)
        self._add(passed, (None, ANYTHING))

    def command(self, word: str) -> None:
        """A line that opens, closes, branches, leaves or goes on."""
        builder, at = self._builder, self._at
        block = builder.blocks.get(at)
        match word:
            case "SUB":
                self._sub()
            case "RETURN" | "ENDSUB":
                self._return()
            case "IF" if block is not None:
                self._choose(2 * at, block)
            case "ELSEIF" | "ELSE" if block is not None:
                self._jump(2 * block.last)
                if word == "ELSEIF":
                    self._choose(2 * at + 1, block)
            case "ENDIF" if block is not None:
                self._jump(builder.behind(at))
                self._jump(builder.behind(at), 2 * at + 1)
            case "WHILE" if block is not None and block.first == at:
                builder.heads[2 * at] = 2 * block.last
                never = "never holds when the program comes here, so that the loop makes no pass"
                self._decide(
                    2 * at, builder.behind(at), builder.behind(block.last), self._idle(builder.behind(at), never)
                )
                self._loop(block, 2 * at, at)
            case "WHILE" if block is not None:
                builder.heads[2 * (block.first + 1)] = 2 * block.last
                never = "never holds here, so that the loop makes one pass only"
                first = 2 * (block.first + 1)
                self._decide(2 * at, first, builder.behind(at), self._idle(first, never))
                self._loop(block, 2 * (block.first + 1), at)
            case "ENDWHILE" if block is not None:
                self._jump(2 * block.first)
            case "REPEAT" if block is not None:
                self._repeat(block)
            case "ENDREPEAT" if block is not None:
                builder.heads[2 * (block.first + 1)] = 2 * block.last
                self._repeated(block)
            case "BREAK" if block is not None:
                self._jump(builder.behind(block.last))
            case "CONTINUE" if block is not None:
                self._jump(2 * (block.last if block.kind == "do" else block.first))
            case _:
                self._jump(builder.behind(at))

    def call(self) -> None:
        """A call with its arguments, or an O-word alone, to which calls by number go."""
        o_line = self._o_line
        if o_line is None or o_line.find("CALL") is None or "DELETE" in self._line.node.kinds:
            raise Torn
        label = self._label(o_line)
        arguments = [self._expressions.value(group) for group in self._groups]
        expressions, behind = self._expressions, self._builder.behind(self._at)
        part = o_line.node("label")
        computed = expressions.value(part.children[0]) if part is not None and label is None else None
        self._builder.callees.add(label if label is not None else UNSEEN)

        def called(env: Env, calls: Calls) -> Flows:
            if computed is not None:
                computed(env)
            values: Env = {at: get(env) for at, get in enumerate(arguments, 1)}
            values.update((at, NO) for at in range(len(arguments) + 1, ARGUMENTS + 1))
            shared = {key: value for key, value in env.items() if is_shared(key)}
            expressions.doubtful = True
            found = calls.call(label if label is not None else UNSEEN, values, shared)
            if found is None:
                return ((behind, {key: value for key, value in env.items() if not is_shared(key)}),)
            if found.env is None:
                return ()
            written = found.written
            left = {k: v for k, v in env.items() if not is_shared(k) or (written is not None and k not in written)}
            return ((behind, {**left, **{k: v for k, v in found.env.items() if is_shared(k)}}),)

        self._builder.add(2 * self._at, self._at, called, expressions, callee=label, calls=True)

    def block(self) -> None:
        """A line that sets parameters and moves the machine."""
        node, expressions = self._line.node, self._expressions
        settings: list[tuple[Callable[[Env], tuple[Hashable, ...] | None], Get]] = []
        words: list[Get] = []
        sets: list[Hashable] = []
        for part in (child.children[0] for child in node.tree.nodes() if child.kind == "item"):
            if isinstance(part, Part) and part.kind == "setting" and isinstance(param := part.children[0], Part):
                settings.append((expressions.target(param), expressions.value(part.children[2])))
                sets.append(set_by(expressions, param))
            elif isinstance(part, Part) and part.kind == "word":
                words.append(expressions.value(part.children[1]))
        behind = STOP if self._line.ends else self._builder.behind(self._at)
        deleted = self._builder.delete if "DELETE" in node.kinds else False
        percent, stopping = "PERCENT" in node.kinds, aborts(node.text)

        def executed(env: Env, calls: Calls) -> Flows:
            puts = [(target(env), get(env)) for target, get in settings]
            for get in words:
                get(env)
            found = put(env, puts)
            # Of several comments only the last one acts.
            return ((behind, found), (STOP, found)) if stopping else ((behind, found),)

        def maybe(env: Env, calls: Calls) -> Flows:
            passed = (self._builder.behind(self._at), env)
            try:
                return (*executed(env, calls), passed)
            except Proof:
                expressions.doubtful = True
                return (passed,)

        if percent:
            # The first one frames the program, the second ends it; what follows that one is not read.
            self._jump(self._builder.behind(self._at))
        elif deleted is True:
            self._jump(self._builder.behind(self._at))
        else:
            self._add(executed if deleted is False else maybe, sets)

    def _add(
        self,
        flow: Callable[[Env, Calls], Flows],
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        number: int | None = None,
        dead: tuple[Dead, ...] = (),
    ) -> None:
        number = 2 * self._at if number is None else number
        self._builder.add(number, self._at, flow, self._expressions, sets, condition, dead=dead)

    def _jump(self, to: int, number: int | None = None) -> None:
        self._add(lambda env, calls: ((to, env),), number=number)

    def _return(self) -> None:
        values = [self._expressions.value(group) for group in self._groups]

        def returned(env: Env, calls: Calls) -> Flows:
            for get in values:
                get(env)
            return ((RETURN, env),)

        self._add(returned)

    def _sub(self) -> None:
        o_line, behind = self._o_line, self._builder.behind(self._at)
        span = Span(o_line.start, o_line.end) if o_line is not None else None
        self._add(lambda env, calls: ((behind, env),), condition=span)

    def _choose(self, number: int, block: Block) -> None:
        """A condition of an `if`. An `elseif` that only says what is left is no fault, nor a branch that only stops the program."""
        then, otherwise = self._builder.behind(self._at), self._otherwise(block, self._at)
        dead: tuple[Dead, ...] = ()
        is_last = otherwise == 2 * block.last + 1
        if not self._is_guard(block):
            dead = self._idle(then, "never holds here, so that what stands under it is never run", CONSTANT)
        if not is_last or number == 2 * self._at:
            always = "always holds here" + ("" if is_last else "; the branches behind it are never run")
            dead += self._idle(otherwise, always, CONSTANT, Severity.INFO)
        self._decide(number, then, otherwise, dead)

    def _is_guard(self, block: Block) -> bool:
        last = next((middle for middle in block.middles if middle > self._at), block.last)
        return any(aborts(line.node.text) for line in self._builder.lines[self._at + 1 : last])

    def _idle(
        self, target: int, why: str, kind: str = "loop-idle", severity: Severity | None = None
    ) -> tuple[Dead, ...]:
        """A way that this line's condition never goes. Of one without parameters, or with EXISTS, nobody expects that it hangs on anything."""
        group = self._groups[0]
        parts = {part.kind for part in walk(group)}
        if "param" not in parts or "exists" in parts:
            return ()
        return (Dead(target, kind, Span(group.start, group.end), f"`{self._expressions.said(group)}` {why}", severity),)

    def _decide(self, number: int, then: int, otherwise: int, dead: tuple[Dead, ...]) -> None:
        learn, get = self._learn()
        condition = self._groups[0]

        def decided(env: Env, calls: Calls) -> Flows:
            get(env)
            ways = ((then, learn(env, True)), (otherwise, learn(env, False)))
            return tuple((to, values) for to, values in ways if values is not None)

        self._add(decided, condition=Span(condition.start, condition.end), number=number, dead=dead)

    def _learn(self) -> tuple[Learn, Get]:
        conditions = Conditions(self._line.node.text, self._expressions, TOLERANCE[self._builder.settings["compare"]])
        return conditions.learn(self._groups[0]), self._expressions.value(self._groups[0])

    def _otherwise(self, block: Block, at: int) -> int:
        """Where it goes on when the condition of a line does not hold."""
        other = next((middle for middle in block.middles if middle > at), None)
        if other is None:
            return 2 * block.last + 1
        bracket = self._builder.lines[other].bracket
        is_elseif = bracket is not None and bracket.word.upper() == "ELSEIF"
        return 2 * other + 1 if is_elseif else 2 * (other + 1)

    def _repeat(self, block: Block) -> None:
        get, body, behind = (
            self._expressions.value(self._groups[0]),
            self._builder.behind(self._at),
            self._builder.behind(block.last),
        )
        group = self._groups[0]
        span, said = Span(group.start, group.end), self._expressions.said(group)
        remarks: list[Proof] = []
        literal = all(part.kind != "param" for part in walk(group))

        def counted(env: Env, calls: Calls) -> Flows:
            times = get(env)
            remarks.clear()
            if not literal and times.exact and abs(times.low - round(times.low)) > NEAR:
                message = (
                    f"`{said}` is {times.low:g} here, which is no integer; the control rounds it to {round(times.low)}"
                )
                remarks.append(Proof("repeat-fraction", span, message))
            ways = [(body, env)] if times.wild or times.high > 0.5 else []
            return (*ways, *([(behind, env)] if times.wild or times.low <= 0.5 else []))

        dead = self._idle(body, "is never more than 0 here, so that the loop makes no pass")
        self._builder.add(
            2 * self._at,
            self._at,
            counted,
            self._expressions,
            condition=span,
            dead=dead,
            remark=lambda: remarks[0] if remarks else None,
        )

    def _repeated(self, block: Block) -> None:
        ways = (2 * (block.first + 1), self._builder.behind(self._at))
        self._add(lambda env, calls: tuple((to, env) for to in ways))

    def _loop(self, block: Block, head: int, test: int) -> None:
        o_line = self._o_line
        assert o_line is not None, "a loop has an O-word"
        self._builder.loops.append(
            Loop(head, 2 * block.first, 2 * block.last, 2 * test, Span(o_line.start, o_line.end), "limit")
        )

    def _label(self, o_line: Part) -> str | None:
        from deburr_grammar.dialects.rs274.outline import label_of

        label = o_line.node("label")
        return label_of(self._line.node.text, label) if label is not None else None
