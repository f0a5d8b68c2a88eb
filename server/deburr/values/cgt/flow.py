"""The flow of a template's section as a graph: brackets, branches, loops, calls and exits (spec/cgt.md §5.2 to §5.6, §11). Solves nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import FEW
from deburr.templates.items import Body, Item
from deburr.templates.parts import Branch, by_line, first_line, last_line, parts_of
from deburr.templates.template import target
from deburr.values.cgt.brackets import tested
from deburr.values.cgt.commands import Asked
from deburr.values.cgt.conditions import Test
from deburr.values.cgt.expressions import Expressions
from deburr.values.cgt.lines import Unread
from deburr.values.cgt.outcomes import before_computing, computed, merged, row_checked, shown, tracked
from deburr.values.cgt.ways import Label, Way, counts, extent, said_of
from deburr.values.cgt.words import ALL, CALL_LEFT, END, ENDED, LEFT, RETURNED, Shown, State, without
from deburr.values.domain import ANY, exactly
from deburr.values.graph import RETURN, Calls, Dead, Env, Flows, Graph, Head, Key, Node
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.templates.parts import Part
    from deburr.templates.symbols import Word
    from deburr.values.cgt.commands import Commands

_LOST = frozenset(("head", "else", "repeat"))
_DEEPEST = 100
"""Levels of brackets and branches; no template comes near."""


class Section(NamedTuple):
    """A section's flow, and the rows of its nodes' lines, counted from its header."""

    graph: Graph
    rows: tuple[int, ...]


class Builder:
    """Builds one section's graph."""

    def __init__(self, commands: Commands, texts: Mapping[int, str], quiet: bool) -> None:
        self._commands = commands
        self._words = commands.words
        self._texts = texts
        self._quiet = quiet
        self._nodes: list[Node] = []
        self._rows: dict[int, int] = {}
        """The rows that have nodes, in order, each with its place among them."""
        self._left = 0
        """How many nodes there were when the work was last left."""
        self._ways: dict[int, tuple[Way, ...]] = {}
        self._loops: list[tuple[int, int]] = []
        self._callees: set[str] = set()
        self._settings: list[tuple[Key, bool]] = []
        """The words that are set, each with whether that is a constant that stands there."""
        self._waiting: list[list[Label]] = []
        """Where `#EXITC` comes back to, by the bodies around: the next line of the innermost that has one."""

    def section(self, body: Body, header: Span) -> Generator[None, None, Section]:
        """The flow of a section's body, built in steps. ``header``: the columns of its header."""
        self._pass(0, span=header)
        yield from self._body(body)
        self._leave(0, ENDED)
        for at, ways in self._ways.items():
            self._nodes[at] = _deciding(self._nodes[at], ways)
        used = frozenset[Key]().union(*{node.used for node in self._nodes}) - {None}
        sets = frozenset[Key]().union(*{node.sets for node in self._nodes})
        shared = frozenset(key for key in used if not _is_local(key))
        written = frozenset(key for key in sets | {END} if not _is_local(key))
        times = Counter(self._settings)
        constants = frozenset(
            key for key, literal in self._settings if literal and times[key, True] == 1 and not times[key, False]
        )
        heads = {first: self._head(first, last) for first, last in self._loops}
        nodes = dict(enumerate(self._nodes))
        graph = Graph(nodes, heads, (), frozenset(), used | sets, shared, written, frozenset(self._callees), constants)
        rows = tuple(self._rows)
        assert all(one < two for one, two in pairwise(rows)), "the parts of a section are gone through in order"
        return Section(graph, rows)

    def _head(self, first: int, last: int) -> Head:
        inside = self._nodes[first : last + 1]
        sets = frozenset(key for node in inside for key in node.sets)
        calls, formats = any(node.calls for node in inside), ALL in sets
        return Head(last, lambda key: calls or key in sets or (formats and isinstance(key, Shown)))

    @property
    def _next(self) -> int:
        return len(self._nodes)

    def _add(
        self,
        row: int,
        flow: Callable[[Env, Calls], Flows],
        span: Span | None = None,
        used: Sequence[Key] = (),
        sets: Sequence[Key] = (),
        *,
        callee: str | None = None,
        calls: bool = False,
        change: Callable[[Env], Env] | None = None,
    ) -> None:
        at = self._rows.setdefault(row, len(self._rows))
        self._nodes.append(
            Node(at, flow, frozenset(used), frozenset(sets), span, callee=callee, calls=calls, change=change)
        )

    def _change(
        self,
        row: int,
        change: Callable[[Env], Env],
        span: Span | None = None,
        used: Sequence[Key] = (),
        sets: Sequence[Key] = (),
    ) -> None:
        """A node that only goes on to the next one."""
        behind = self._next + 1
        self._add(row, lambda env, calls: ((behind, change(env)),), span, used, sets, change=change)

    def _pass(self, row: int, span: Span | None = None) -> None:
        """A node that does nothing but go on."""
        self._change(row, lambda env: env, span)

    def _jump(self, row: int, label: Label) -> None:
        """A node that does nothing but go on elsewhere."""
        self._add(row, lambda env, calls: ((label.at, env),))

    def _leave(self, row: int, how: float, span: Span | None = None) -> None:
        ended = exactly(how)
        self._add(row, lambda env, calls: ((RETURN, {**env, END: ended}),), span)

    def _body(self, body: Body) -> Iterator[None]:
        self._waiting.append([])
        if len(self._waiting) > _DEEPEST:
            raise Unread
        line = body.opener.line if body.opener is not None else None
        for parts in by_line(parts_of(body)):
            if line is not None and first_line(parts[0]) > line:
                self._resolve(self._waiting[-1])
            yield from self._parts(parts)
            if self._next - self._left >= FEW:
                self._left = self._next
                yield
            line = last_line(parts[-1])
        if line is not None and (body.opener is None or (body.closer is not None and body.closer.line > line)):
            self._resolve(self._waiting[-1])
        left = self._waiting.pop()
        if self._waiting:
            self._waiting[-1] += left
        else:
            self._resolve(left)

    def _resolve(self, labels: list[Label]) -> None:
        for label in labels:
            label.at = self._next
        labels.clear()

    def _parts(self, parts: Sequence[Part]) -> Iterator[None]:
        output: list[Item] = []
        for part in parts:
            if isinstance(part, Item) and part.kind == "word":
                word = self._words.find(part.name) if part.name else None
                if word is not None and self._words.computes(word):
                    self._output(output)
                    self._compute(part, [word])
                output.append(part)
                continue
            if isinstance(part, Item) and part.node is None and part.kind not in (*_LOST, "exit"):
                continue
            self._output(output)
            if isinstance(part, Branch):
                yield from self._branch(part)
            elif isinstance(part, Body):
                yield from self._repeat(part)
            else:
                self._item(part)
        self._output(output)

    def _output(self, items: list[Item]) -> None:
        """Words one after the other on a line."""
        if not items:
            return
        words = [(item, word) for item in items if (word := self._words.find(item.name)) is not None]
        keys = tuple(key for _, word in words if (key := tracked(word, self._words)) is not None)
        checks = [
            (word.name, row_checked(count, word.name, item.span))
            for item, word in words
            if word.type == "table" and (count := self._words.codes(word)) is not None
        ]

        # The builder, which holds the nodes, is not in one of them: they go with the graph.
        quiet = self._quiet

        def put(env: Env) -> Env:
            for name, check in checks:
                check(env.get(name, ANY))
            return shown(env, keys, quiet)

        used = [word.name for _, word in words if self._words.holds(word)]
        self._change(items[0].line, put, Span(items[0].start, items[-1].end), used, keys)
        items.clear()

    def _item(self, item: Item) -> None:
        if item.kind in _LOST:
            raise Unread
        if item.kind == "call":
            self._call(item)
        elif item.kind == "exit":
            self._leave(item.line, LEFT if item.name == "EXIT" else CALL_LEFT, item.span)
        elif item.node is not None:
            command = self._commands.command(item, item.node, self._texts[item.line])
            self._compute(item, command.computed)
            if command.setting is not None:
                self._settings.append(command.setting)
            if command.outcome is not None:
                change, sets = command.outcome
                self._change(item.line, change, item.span, command.used, sets)

    def _compute(self, item: Item, words: Sequence[Word]) -> None:
        """Words whose sections are run before an item."""
        for word in words:
            self._computing(item, word)

    def _computing(self, item: Item, word: Word) -> None:
        name, behind = self._words.computes(word), self._next + 1
        keys: tuple[Key, ...] = (word.name,)
        if name not in self._words.sections:
            self._change(item.line, lambda env: without(env, *keys), item.span, (), keys)
            return
        self._callees.add(name)

        def run(env: Env, calls: Calls) -> Flows:
            before = before_computing(word, env)
            found = calls.call(name, {}, before)
            after = computed(word, before, found) if found is not None else None
            if after is None:
                return ()
            return ((behind, {**after, RETURNED: env[RETURNED]} if RETURNED in env else after),)

        self._add(item.line, run, item.span, (), keys, callee=name, calls=True)

    def _call(self, item: Item) -> None:
        name, span = target(item)
        behind, label = self._next + 1, Label()
        if name not in self._words.sections:
            # There is no such section, or only a table: another rule says so.
            self._pass(item.line)
            return
        self._callees.add(name)
        jumps = item.name == "GOTO"
        if not jumps:
            self._waiting[-1].append(label)

        def called(env: Env, calls: Calls) -> Flows:
            found = calls.call(name, {}, without(env, END))
            after = merged(env, found) if found is not None else None
            if after is None:
                return ()
            if jumps:
                return ((RETURN, after),)
            how, after = after.get(END, ANY), without(after, END)
            left = {**after, END: exactly(LEFT)}
            ways = ((ENDED, behind, after), (CALL_LEFT, label.at, after), (LEFT, RETURN, left))
            return tuple((to, values) for end, to, values in ways if how.has(end))

        self._add(item.line, called, span, callee=name, calls=True)

    def _branch(self, branch: Branch) -> Iterator[None]:
        """A bracket or an `#IF`."""
        body = branch.body
        head = body.head or body.opener
        assert head is not None
        test, used, words = self._test(body)
        self._compute(head, words)
        other, end = Label(), Label()
        if used:
            self._ways[self._next] = tuple(said_of(body, self._next + 1, other))
        self._decide(head, body, test, used, other)
        inside = self._next
        yield from self._body(body)
        if branch.other is not None:
            self._jump(head.line, end)
        elif self._next == inside:
            # So that it can be told whether the body is output.
            self._pass(head.line)
        other.at = self._next
        if branch.other is not None:
            yield from self._body(branch.other)
        end.at = self._next

    def _test(self, body: Body) -> Asked:
        """What a branch asks."""
        if body.head is None:
            changed = tested(body, self._words)
            return Asked(changed.ways, changed.keys, changed.computed)
        node = body.head.node
        if node is None:
            raise Unread
        return self._commands.asked(body.head, node, self._texts[body.head.line])

    def _decide(self, head: Item, body: Body, test: Test, used: Sequence[Key], other: Label) -> None:
        inside = self._next + 1

        def decided(env: Env, calls: Calls) -> Flows:
            then, otherwise = test(env)
            if then is None:
                return () if otherwise is None else ((other.at, otherwise),)
            return ((inside, then),) if otherwise is None else ((inside, then), (other.at, otherwise))

        sets = tuple(key for key in used if isinstance(key, Shown))
        self._add(head.line, decided, extent(head, body), used, sets)

    def _repeat(self, body: Body) -> Iterator[None]:
        head = body.head
        if body.kind != "repeat" or head is None or head.node is None:
            raise Unread
        expressions = Expressions(self._texts[head.line], self._words)
        self._compute(head, expressions.computed(head.node))
        part = head.node.children[2]
        get, key, said = expressions.number(part), expressions.key(part), expressions.said(part)
        first, end, count = self._next + 1, Label(), State(self._next)
        span = expressions.span(part)

        def entered(env: Env, calls: Calls) -> Flows:
            value = counts(get(env), said, span)
            if key is not None:
                env = {**env, key: value}
            ways = ((first, {**env, count: value}),) if value.high >= 1 else ()
            return (*ways, (end.at, env)) if value.low < 1 else ways

        if part.kind != "NUMBER":
            message = f"`{said}` can only be 0 here, so that the loop makes no pass"
            self._ways[self._next] = (Way(first, "loop-idle", message),)
        self._add(head.line, entered, span, tuple(expressions.used))
        self._pass(head.line)
        yield from self._body(body)
        self._loops.append((first, self._next))
        behind = self._next + 1

        def again(env: Env, calls: Calls) -> Flows:
            once = env.get(count, ANY).high < 2
            after = without(env, count)
            return ((behind, after),) if once else ((first, env), (behind, after))

        self._add(head.line, again)
        end.at = self._next


def _deciding(node: Node, ways: Sequence[Way]) -> Node:
    """A node with what is said of its ways, which are known by now; nothing where several of them lead to the same place."""
    targets = [way.to if isinstance(way.to, int) else way.to.at for way in ways]
    condition = node.condition
    if condition is None or len(set(targets)) < len(ways):
        return node
    dead = (Dead(to, way.kind, condition, way.message, way.severity) for way, to in zip(ways, targets) if way.kind)
    return node._replace(dead=tuple(dead))


def _is_local(key: Key) -> bool:
    """Whether a key is a section's own: the count of a loop."""
    return isinstance(key, State) and isinstance(key.of, int)
