"""The flow of a MetaGCODE text as a graph: conditions, loops, words with a sign (spec/metagcode.md §5). Solves nothing.

Variables never change, so a loop is gone through once: whatever holds in one of its passes is
known from its head.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from functools import lru_cache
from itertools import count
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import FEW, paced
from deburr.values.domain import NO, WILD, Value, may_be_zero, without_zero
from deburr.values.graph import STOP, Calls, Env, Flows, Graph, Key, Node, Proof
from deburr.values.kept import LINES, Kept
from deburr.values.metagcode.asking import asked, with_all_orders
from deburr.values.metagcode.conditions import COMPARED, Item, as_number, is_negative, item_of
from deburr.values.metagcode.lines import SIGNED, Line, Taken, Unseen, taken
from deburr.values.metagcode.orders import Order
from deburr.values.program import Routine
from deburr.values.remembering import remembering
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.forms import condition, groups, is_numeric
from deburr_grammar.dialects.metagcode.limits import NESTED, PASSES
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.line import LineNode

_NAME = "text"
_ROUNDED = 0.5
"""What a printed value is away from the exact one at most, whatever number of decimals is asked for."""
_SLACK = 1 + 1e-9
_graphs: Kept[Graph] = Kept()


def routine_of(analysis: Analysis) -> Generator[None, None, Routine | None]:
    """The text as a routine, found in steps; None where blocks do not fit together or snippets cannot be seen."""
    try:
        found = yield from taken(analysis)
    except Unseen:
        return None
    blocks = _blocks(found.lines)
    if blocks is None:
        return None
    key = (analysis.file, tuple(found.files), tuple([line.node.text for line in found.lines]))
    graph = _graphs.get(key)
    if graph is None:
        made = yield from _graph(found, blocks, analysis.file)
        graph = _graphs.add(key, made, len(found.lines))
    return Routine(_NAME, found.rows, graph, {}, found.files, between=analysis.file)


class _End(NamedTuple):
    """One end of a block: where the other one is, and how many blocks are around it."""

    other: int
    depth: int


_NONE = _End(-1, 0)


def _blocks(lines: Sequence[Line]) -> dict[int, _End] | None:
    """The ends of blocks; None if they do not fit, or a line cannot be read."""
    found: dict[int, _End] = {}
    opened: list[int] = []
    for at in [at for at, line in enumerate(lines) if line.bracket is not None and line.bracket.kind != SNIPPET]:
        line, bracket = lines[at], lines[at].bracket
        if bracket is None or line.node.problems or bracket.role is Role.MIDDLE or len(opened) > NESTED:
            return None
        if bracket.role is Role.OPEN:
            opened.append(at)
            continue
        start = opened.pop() if opened else at
        other = lines[start].bracket
        if other is None or start == at or (other.kind, other.label) != (bracket.kind, bracket.label):
            return None
        found[start], found[at] = _End(at, len(opened)), _End(start, len(opened))
    return None if opened else found


def _graph(taken: Taken, blocks: dict[int, _End], main: str) -> Generator[None, None, Graph]:
    nodes: dict[int, Node] = {}
    texts: dict[int, Node] = {}
    seen: dict[Line, int] = {}
    end = len(taken.lines)
    for each in paced(zip(count(), taken.files, taken.lines), FEW):
        if each is None:
            yield
            continue
        at, file, line = each
        number = seen[line] = seen.get(line, -1) + 1
        other, depth = blocks.get(at, _NONE)
        behind, beyond = at + 1 if at + 1 < end else STOP, other + 1 if other + 1 < end else STOP
        nodes[at] = node = _node(at, line, number, depth, file == main, behind, beyond)
        if line.compares_texts:
            texts[at] = node
    nodes.update(with_all_orders(texts))
    nothing = frozenset[Key]()
    return Graph(nodes, {}, (), nothing, None, nothing, nothing, frozenset(), family=("metagcode", main))


@lru_cache(maxsize=2 * LINES)
def _node(at: int, line: Line, number: int, depth: int, own: bool, behind: int, beyond: int) -> Node:
    """The node of a line where it stands; after an edit that moves nothing it is the same one. ``beyond``: behind the other end of its block."""
    made = _made(line, number, depth, own)
    ways = (behind, beyond)
    dead = tuple([each._replace(target=ways[each.target]) for each in made.dead]) if made.dead else ()
    return Node(at, _Placed(made, ways), made.used, condition=made.condition, remark=made.remark, dead=dead)


@lru_cache(maxsize=2 * LINES)
def _made(line: Line, number: int, depth: int, own: bool) -> Node:
    """The node of a line, wherever it stands. ``number``: of the lines that say the same, because each remembers its own values."""
    return remembering(_new_node(line.node, line.bracket, depth, own))


class _Placed:
    """The flow of a node that was made to go on at `_BEHIND` or `_BEYOND`, at the place of these."""

    __slots__ = ("_flow", "_flows", "_last", "_ways")

    def __init__(self, made: Node, ways: tuple[int, int]) -> None:
        self._flow = made.flow
        self._ways = ways
        self._last: Flows | None = None
        self._flows: Flows = ()

    def __call__(self, env: Env, calls: Calls) -> Flows:
        """What comes next."""
        found = self._flow(env, calls)
        if found is not self._last:
            self._last = found
            self._flows = tuple([(self._ways[way], values) for way, values in found])
        return self._flows


_BEHIND, _BEYOND = 0, 1
"""The ways of a node that stands nowhere yet: to the next line, and behind the other end of its block."""


def _new_node(line: LineNode, bracket: Bracket | None, depth: int, own: bool) -> Node:
    if bracket is None:
        return _words(line)
    if bracket.kind == SNIPPET:
        return Node(0, lambda env, calls: ((_BEHIND, env),))
    if bracket.role is Role.CLOSE:
        return Node(0, _closed(depth), condition=bracket.span)
    for part in line.find("condition"):
        said = condition(part)
        left, right = item_of(line, said.left), item_of(line, said.right)
        word = line.text[said.operator.start : said.operator.end].lower()
        if word in COMPARED and said.type.kind == "TYPE":
            numeric = is_numeric(line.text[said.type.start : said.type.end])
            return asked(left, word, right, numeric, (_BEHIND, _BEYOND), own)
    for part in line.find("header"):
        counters = [
            Counter(item_of(line, group.counter), item_of(line, group.step), line.text[group.mode.start] in "rR")
            for group in groups(part)
            if (group.counter.kind, group.mode.kind) == ("VARIABLE", "MODE")
        ]
        if len(counters) == len(groups(part)) and all(map(_is_sound, counters)):
            return _loop(depth, counters, bracket.span)
    return Node(0, lambda env, calls: ((_BEHIND, env), (_BEYOND, env)), condition=bracket.span)


class Counter(NamedTuple):
    """A variable of a loop with its maxStep."""

    total: Item
    step: Item
    relative: bool


class Outside(NamedTuple):
    """A key for what holds outside of a loop meanwhile. ``depth``: how many blocks are around the loop; ``of``: the variable, or the order in which it stands."""

    depth: int
    of: Key


def _loop(depth: int, counters: Sequence[Counter], span: Span) -> Node:
    items = [item for counter in counters for item in counter[:2]]
    used = frozenset(item.name for item in items if item.name is not None)
    remarks: list[Proof] = []

    def entered(env: Env, calls: Calls) -> Flows:
        remarks.clear()
        found: Env = {item.name: as_number(item, env) for item in items if item.name is not None}
        env = {**env, **found}
        for counter in counters:
            _judge_step(counter, env, remarks)
            if counter.step.name is not None:
                env[counter.step.name] = without_zero(counter.step.of(env))
        totals = [counter.total.of(env) for counter in counters]
        for counter in counters:
            _judge_length(counter, env)
        if all(total == NO for total in totals):
            first = counters[0].total
            message = f"`|{first.name}|` can only be 0 here, so the loop has no pass and its lines are left out"
            remarks.append(Proof("loop-zero", first.span, message))
            return ((_BEYOND, env),)
        counted = {counter.total.name for counter in counters}
        inside = {key: value for key, value in env.items() if not (isinstance(key, Order) and key.is_of(counted))}
        inside.update((Outside(depth, key), value) for key, value in env.items() if key not in inside)
        inside.update((Outside(depth, counter.total.name), total) for counter, total in zip(counters, totals))
        for counter, total in zip(counters, totals):
            inside[counter.total.name] = _counted(total, counter, env)
        skipped = ((_BEYOND, env),) if all(map(may_be_zero, totals)) else ()
        return ((_BEHIND, inside), *skipped)

    return Node(0, entered, used, condition=span, remark=lambda: remarks[0] if remarks else None)


def _is_sound(counter: Counter) -> bool:
    """Whether the line alone says nothing against a step."""
    return counter.step.name is not None or (counter.step.literal != NO and not counter.step.literal.empty)


def _judge_step(counter: Counter, env: Env, remarks: list[Proof]) -> None:
    step, size = counter.step, counter.step.of(env)
    if step.name is None:
        return
    if size == NO:
        message = f"`|{step.name}|` can only be 0 here; a step of 0 never reaches the total, and the number of passes would be a division by zero"
        raise Proof("loop-step-zero", step.span, message)
    if is_negative(size):
        message = f"`|{step.name}|` is always below 0 here; the sign is ignored, the direction is that of `|{counter.total.name}|`"
        remarks.append(Proof("loop-step-negative", step.span, message))


def _judge_length(counter: Counter, env: Env) -> None:
    total, size = counter.total.of(env), counter.step.of(env)
    least, most = max(total.low, -total.high, 0.0), max(-size.low, size.high)
    if least > PASSES * most * _SLACK:
        message = f"`|{counter.total.name}|` is so large here that the loop makes more than {PASSES:,} passes, and it may not make more"
        raise Proof("limit", counter.total.span, message)


def _counted(total: Value, counter: Counter, env: Env) -> Value:
    """What a loop's variable is printed as in its passes."""
    low, high = min(total.low, 0.0), max(total.high, 0.0)
    if counter.relative:
        size = counter.step.of(env)
        most = max(-size.low, size.high)
        low, high = max(low, -most), min(high, most)
    return Value(low - 2 * _ROUNDED, high + 2 * _ROUNDED)


def _closed(depth: int) -> Callable[[Env, Calls], Flows]:
    """The end of a block: behind a loop its variables are again what they were."""

    def restored(env: Env, calls: Calls) -> Flows:
        saved = {key.of: value for key, value in env.items() if isinstance(key, Outside) and key.depth == depth}
        if not saved:
            return ((_BEHIND, env),)
        counted = {name for name in saved if isinstance(name, str)}
        left = {key: value for key, value in env.items() if not _is_inside(key, depth, counted)}
        return ((_BEHIND, {**left, **saved}),)

    return restored


def _is_inside(key: Key, depth: int, counted: set[str]) -> bool:
    """Whether something is known in a loop only."""
    if isinstance(key, Order):
        return key.is_of(counted)
    return isinstance(key, Outside) and key.depth == depth


def _words(line: LineNode) -> Node:
    """A line of G-code: a value below 0 behind a sign makes two signs of it."""
    text = line.text
    comments = [(part.start, part.end) for part in line.find("comment")]
    signed = [
        (match[2].strip(" \t"), Span(*match.span(1)))
        for match in SIGNED.finditer(text)
        if not any(start <= match.start(1) < end for start, end in comments)
    ]

    def filled(env: Env, calls: Calls) -> Flows:
        for variable, span in signed:
            value = env.get(variable, WILD)
            if is_negative(value):
                message = f"`|{variable}|` is always below 0 here, and a sign stands before it already; write the sign in the line or in the value, not in both"
                raise Proof("double-sign", span, message)
        return ((_BEHIND, env),)

    return Node(0, filled, frozenset(variable for variable, _ in signed), condition=signed[0][1] if signed else None)
