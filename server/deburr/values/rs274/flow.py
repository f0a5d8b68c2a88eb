"""The flow of an RS274 main program or subprogram as a graph: lines, blocks, loops, calls and returns (spec/rs274.md §6). Solves nothing.

Lines have even numbers. A condition of `elseif` has the odd one behind its line, because who comes to the line itself comes from a branch that ran.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from deburr.arithmetic.rs274 import TOLERANCE
from deburr.values.domain import ANY, NO, Value, joined
from deburr.values.graph import RETURN, STOP, Calls, Env, Flows, Graph, Head, Loop, Node, Proof
from deburr.values.rs274.conditions import Conditions
from deburr.values.rs274.expressions import ARGUMENTS, Expressions
from deburr.values.rs274.lines import aborts
from deburr_grammar.dialect import Role
from deburr_grammar.text import Span
from deburr_grammar.tree import Node as Part

if TYPE_CHECKING:
    from deburr.values.rs274.conditions import Learn
    from deburr.values.rs274.expressions import Get
    from deburr.values.rs274.lines import Taken


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


class Builder:
    """Builds one routine's graph."""

    def __init__(
        self, lines: Sequence[Taken], is_main: bool, settings: Mapping[str, Any], block_delete: bool | None
    ) -> None:
        self._lines = lines
        self._settings = settings
        self._delete = block_delete
        self._end = STOP if is_main else RETURN
        self._nodes: dict[int, Node] = {}
        self._blocks: dict[int, Block] = {}
        self._loops: list[Loop] = []
        self._heads: dict[int, int] = {}
        self._callees: set[str] = set()
        self._used: set[Hashable] = set()
        self._sets: set[Hashable] = set()

    def graph(self) -> Graph:
        """The routine's flow."""
        self._pair()
        for at, line in enumerate(self._lines):
            self._take(at, line)
        everything = self._used | self._sets
        own = frozenset(key for key in everything if isinstance(key, str) and not key.startswith("_"))
        return Graph(
            self._nodes,
            {head: self._head(head, last) for head, last in self._heads.items() if head in self._nodes},
            tuple(loop for loop in self._loops if loop.head in self._nodes),
            own,
            None if None in everything else frozenset(everything),
            _shared(self._used),
            _shared(self._sets),
            frozenset(self._callees),
        )

    def _head(self, first: int, last: int) -> Head:
        inside = [self._nodes[at] for at in range(first, last + 1) if at in self._nodes]
        sets = frozenset(key for node in inside for key in node.sets)
        numbers, calls = None in sets, any(node.calls for node in inside)
        anything = ANYTHING in sets

        def may_set(key: Hashable) -> bool:
            return anything or key in sets or (numbers and isinstance(key, int)) or (calls and is_shared(key))

        return Head(last, may_set)

    def _pair(self) -> None:
        around: list[Block] = []
        for at, line in enumerate(self._lines):
            bracket = line.bracket
            if bracket is None or bracket.role in (Role.REGION, Role.END_REGION):
                continue
            if bracket.label is None or "DELETE" in line.node.kinds or line.node.problems:
                raise Torn
            if bracket.role is Role.OPEN:
                around.append(Block(bracket.kind, bracket.label, at))
                self._blocks[at] = around[-1]
            elif bracket.role is Role.CLOSE and around:
                self._blocks[at] = around.pop()
                self._blocks[at].last = at
            elif bracket.kind != "sub":
                self._blocks[at] = self._middle(around, bracket.kind, bracket.label, at)

    def _middle(self, around: list[Block], kind: str, label: str, at: int) -> Block:
        if kind == "if" and around and around[-1].kind == "if" and around[-1].label == label:
            around[-1].middles.append(at)
            return around[-1]
        for block in reversed(around):
            if block.kind in ("while", "do") and block.label == label:
                return block
        raise Torn

    def _take(self, at: int, line: Taken) -> None:
        text = line.node.text
        expressions = Expressions(text, self._settings, lambda name: _is_predefined(line, name))
        commands = _Commands(self, at, line, expressions)
        command = line.bracket.word.upper() if line.bracket is not None else ""
        if line.node.problems:
            commands.unread()
        elif line.bracket is not None:
            commands.command(command)
        elif "o_line" in line.node.kinds:
            commands.call()
        else:
            commands.block()

    def _next(self, at: int) -> int:
        return 2 * (at + 1) if at + 1 < len(self._lines) else self._end

    def _add(
        self,
        number: int,
        at: int,
        flow: Callable[[Env, Calls], Flows],
        expressions: Expressions,
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        callee: str | None = None,
        calls: bool = False,
    ) -> None:
        def flowing(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = False
            return flow(env, calls)

        used = frozenset(expressions.used)
        self._used |= used
        self._sets |= set(sets)
        self._nodes[number] = Node(
            at, flowing, used, frozenset(sets), condition, lambda: expressions.doubtful, callee, calls
        )


class _Commands:
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
        expressions, behind = self._expressions, self._builder._next(self._at)

        def passed(env: Env, calls: Calls) -> Flows:
            expressions.doubtful = True
            return ((behind, {}),)

        expressions.used.add(None)
        self._add(passed, (None, ANYTHING))

    def command(self, word: str) -> None:
        """A line that opens, closes, branches, leaves or goes on."""
        builder, at = self._builder, self._at
        block = builder._blocks.get(at)
        match word:
            case "SUB":
                self._jump(builder._next(at))
            case "RETURN" | "ENDSUB":
                self._return()
            case "IF" if block is not None:
                self._decide(2 * at, builder._next(at), self._otherwise(block, at))
            case "ELSEIF" | "ELSE" if block is not None:
                self._jump(2 * block.last)
                if word == "ELSEIF":
                    self._decide(2 * at + 1, builder._next(at), self._otherwise(block, at))
            case "WHILE" if block is not None and block.first == at:
                builder._heads[2 * at] = 2 * block.last
                self._decide(2 * at, builder._next(at), builder._next(block.last))
                self._loop(block, 2 * at, at)
            case "WHILE" if block is not None:
                builder._heads[2 * (block.first + 1)] = 2 * block.last
                self._decide(2 * at, 2 * (block.first + 1), builder._next(at))
                self._loop(block, 2 * (block.first + 1), at)
            case "ENDWHILE" if block is not None:
                self._jump(2 * block.first)
            case "REPEAT" if block is not None:
                self._repeat(block)
            case "ENDREPEAT" if block is not None:
                builder._heads[2 * (block.first + 1)] = 2 * block.last
                self._repeated(block)
            case "BREAK" if block is not None:
                self._jump(builder._next(block.last))
            case "CONTINUE" if block is not None:
                self._jump(2 * (block.last if block.kind == "do" else block.first))
            case _:
                self._jump(builder._next(at))

    def call(self) -> None:
        """A call with its arguments, or an O-word alone, to which calls by number go."""
        o_line = self._o_line
        if o_line is None or o_line.find("CALL") is None or "DELETE" in self._line.node.kinds:
            raise Torn
        label = self._label(o_line)
        arguments = [self._expressions.value(group) for group in self._groups]
        expressions, behind = self._expressions, self._builder._next(self._at)
        part = o_line.node("label")
        computed = expressions.value(part.children[0]) if part is not None and label is None else None
        self._builder._callees.add(label if label is not None else UNSEEN)

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

        self._builder._add(2 * self._at, self._at, called, expressions, callee=label, calls=True)

    def block(self) -> None:
        """A line that sets parameters and moves the machine."""
        node, expressions = self._line.node, self._expressions
        settings: list[tuple[Callable[[Env], tuple[Hashable, ...] | None], Get]] = []
        words: list[Get] = []
        sets: list[Hashable] = []
        for part in (child.children[0] for child in node.tree.nodes() if child.kind == "item"):
            if isinstance(part, Part) and part.kind == "setting" and isinstance(param := part.children[0], Part):
                settings.append((expressions.target(param), expressions.value(part.children[2])))
                sets.append(_set(expressions, param))
            elif isinstance(part, Part) and part.kind == "word":
                words.append(expressions.value(part.children[1]))
        behind = STOP if self._line.ends else self._builder._next(self._at)
        deleted = self._builder._delete if "DELETE" in node.kinds else False
        percent, stopping = "PERCENT" in node.kinds, aborts(node.text)

        def executed(env: Env, calls: Calls) -> Flows:
            puts = [(target(env), get(env)) for target, get in settings]
            for get in words:
                get(env)
            found = _put(env, puts)
            # Of several comments only the last one acts.
            return ((behind, found), (STOP, found)) if stopping else ((behind, found),)

        def maybe(env: Env, calls: Calls) -> Flows:
            passed = (self._builder._next(self._at), env)
            try:
                return (*executed(env, calls), passed)
            except Proof:
                expressions.doubtful = True
                return (passed,)

        if percent:
            # The first one frames the program, the second ends it; what follows that one is not read.
            self._jump(self._builder._next(self._at))
        elif deleted is True:
            self._jump(self._builder._next(self._at))
        else:
            self._add(executed if deleted is False else maybe, sets)

    def _add(
        self,
        flow: Callable[[Env, Calls], Flows],
        sets: Sequence[Hashable] = (),
        condition: Span | None = None,
        number: int | None = None,
    ) -> None:
        number = 2 * self._at if number is None else number
        self._builder._add(number, self._at, flow, self._expressions, sets, condition)

    def _jump(self, to: int) -> None:
        self._add(lambda env, calls: ((to, env),))

    def _return(self) -> None:
        values = [self._expressions.value(group) for group in self._groups]

        def returned(env: Env, calls: Calls) -> Flows:
            for get in values:
                get(env)
            return ((RETURN, env),)

        self._add(returned)

    def _decide(self, number: int, then: int, otherwise: int) -> None:
        learn, get = self._learn()
        condition = self._groups[0]

        def decided(env: Env, calls: Calls) -> Flows:
            get(env)
            ways = ((then, learn(env, True)), (otherwise, learn(env, False)))
            return tuple((to, values) for to, values in ways if values is not None)

        self._add(decided, condition=Span(condition.start, condition.end), number=number)

    def _learn(self) -> tuple[Learn, Get]:
        conditions = Conditions(self._line.node.text, self._expressions, TOLERANCE[self._builder._settings["compare"]])
        return conditions.learn(self._groups[0]), self._expressions.value(self._groups[0])

    def _otherwise(self, block: Block, at: int) -> int:
        """Where it goes on when the condition of a line does not hold."""
        other = next((middle for middle in block.middles if middle > at), None)
        if other is None:
            return 2 * block.last
        bracket = self._builder._lines[other].bracket
        is_elseif = bracket is not None and bracket.word.upper() == "ELSEIF"
        return 2 * other + 1 if is_elseif else 2 * (other + 1)

    def _repeat(self, block: Block) -> None:
        get, body, behind = (
            self._expressions.value(self._groups[0]),
            self._builder._next(self._at),
            self._builder._next(block.last),
        )
        group = self._groups[0]

        def counted(env: Env, calls: Calls) -> Flows:
            times = get(env)
            ways = [(body, env)] if times.wild or times.high > 0.5 else []
            return (*ways, *([(behind, env)] if times.wild or times.low <= 0.5 else []))

        self._add(counted, condition=Span(group.start, group.end))

    def _repeated(self, block: Block) -> None:
        ways = (2 * (block.first + 1), self._builder._next(self._at))
        self._add(lambda env, calls: tuple((to, env) for to in ways))

    def _loop(self, block: Block, head: int, test: int) -> None:
        o_line = self._o_line
        assert o_line is not None, "a loop has an O-word"
        self._builder._loops.append(
            Loop(head, 2 * block.first, 2 * block.last, 2 * test, Span(o_line.start, o_line.end), "limit")
        )

    def _label(self, o_line: Part) -> str | None:
        from deburr_grammar.dialects.rs274.outline import label_of

        label = o_line.node("label")
        return label_of(self._line.node.text, label) if label is not None else None


UNSEEN = " "
"""The label of a call of which only the run knows where it leads. No label has a blank in it."""
ANYTHING = " "
"""What stands among the parameters that a line sets for all that there are. No name has a blank in it."""


def is_shared(key: Hashable) -> bool:
    """Whether a parameter is the same in a subprogram and in its caller."""
    return key.startswith("_") if isinstance(key, str) else isinstance(key, int) and key > ARGUMENTS


def _put(env: Env, puts: Sequence[tuple[tuple[Hashable, ...] | None, Value]]) -> Env:
    """The values behind a line that sets some."""
    if not puts:
        return env
    found = dict(env)
    for keys, value in puts:
        if keys is None:
            found = {key: old for key, old in found.items() if isinstance(key, str)}
        elif len(keys) == 1:
            found[keys[0]] = value
            if value == ANY:
                del found[keys[0]]
        else:
            found.update({key: joined(found[key], value) for key in keys if key in found})
    return found


def _set(expressions: Expressions, param: Part) -> Hashable:
    """The parameter that a setting sets, if the line alone tells; None: who knows which."""
    name = expressions.name(param)
    if name is not None:
        return name
    return expressions.literal(param)


def _shared(keys: set[Hashable]) -> frozenset[Hashable] | None:
    """Those that other routines can set and read; None: who knows which."""
    return None if None in keys else frozenset(key for key in keys if is_shared(key))


def _is_predefined(line: Taken, name: str) -> bool:
    """Whether only the control sets a name."""
    if not name.startswith("_"):
        return False
    return name.startswith(("_hal[", "_ini[", "_abs_")) or line.node.dialect.codes.entry("variable", name) is not None
