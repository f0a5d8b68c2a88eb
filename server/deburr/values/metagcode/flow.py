"""The flow of a MetaGCODE text as a graph: conditions, loops, words with a sign (spec/metagcode.md §5). Solves nothing.

Variables never change, so a loop is gone through once: whatever holds in one of its passes is
known from its head.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.steps import paced
from deburr.values.domain import NO, WILD, Value, may_be_zero, without_zero
from deburr.values.graph import STOP, Calls, Env, Flows, Graph, Key, Node, Proof
from deburr.values.kept import LINES, Kept
from deburr.values.metagcode.asking import asked, with_all_orders
from deburr.values.metagcode.conditions import COMPARED, Item, as_number, is_negative, item_of
from deburr.values.metagcode.lines import SIGNED, Taken, Unseen, taken
from deburr.values.metagcode.orders import Order
from deburr.values.program import Routine
from deburr.values.remembering import remembering
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.forms import condition, groups, is_numeric
from deburr_grammar.dialects.metagcode.limits import NESTED, PASSES
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
        lines = yield from taken(analysis)
    except Unseen:
        return None
    partners = _partners(lines)
    if partners is None:
        return None
    key = (analysis.file, tuple((line.file, line.node.text) for line in lines))
    graph = _graphs.get(key)
    if graph is None:
        made = yield from _graph(lines, partners, analysis.file)
        graph = _graphs.add(key, made, len(lines))
    return Routine(_NAME, [line.row for line in lines], graph, {}, [line.file for line in lines])


def _partners(lines: Sequence[Taken]) -> dict[int, int] | None:
    """The other ends of blocks; None if they do not fit, or a line cannot be read."""
    found: dict[int, int] = {}
    opened: list[int] = []
    for at, line in enumerate(lines):
        if line.bracket is None:
            continue
        if line.node.problems or line.bracket.role is Role.MIDDLE or len(opened) > NESTED:
            return None
        if line.bracket.role is Role.OPEN:
            opened.append(at)
            continue
        start = opened.pop() if opened else at
        other = lines[start].bracket
        if other is None or start == at or (other.kind, other.label) != (line.bracket.kind, line.bracket.label):
            return None
        found[start], found[at] = at, start
    return None if opened else found


def _graph(lines: Sequence[Taken], partners: dict[int, int], main: str) -> Generator[None, None, Graph]:
    nodes = {}
    for each in paced(enumerate(lines)):
        if each is None:
            yield
            continue
        at, line = each
        behind, beyond = (to if to < len(lines) else STOP for to in (at + 1, partners.get(at, at) + 1))
        nodes[at] = _node(at, line.node, line.bracket, behind, beyond, line.file == main)
    return Graph(with_all_orders(nodes), {}, (), frozenset(), None, frozenset(), frozenset(), frozenset())


@lru_cache(maxsize=2 * LINES)
def _node(at: int, line: LineNode, bracket: Bracket | None, behind: int, beyond: int, own: bool) -> Node:
    """The node of a line; after an edit elsewhere it is the same one. ``beyond``: behind the other end of its block."""
    return remembering(_new_node(at, line, bracket, behind, beyond, own))


def _new_node(at: int, line: LineNode, bracket: Bracket | None, behind: int, beyond: int, own: bool) -> Node:
    if bracket is None:
        return _words(at, line, behind)
    if bracket.role is Role.CLOSE:
        return Node(at, _closed(beyond - 1, behind), condition=bracket.span)
    for part in line.find("condition"):
        said = condition(part)
        left, right = item_of(line, said.left), item_of(line, said.right)
        word = line.text[said.operator.start : said.operator.end].lower()
        if word in COMPARED and said.type.kind == "TYPE":
            numeric = is_numeric(line.text[said.type.start : said.type.end])
            return asked(at, left, word, right, numeric, (behind, beyond), own)
    for part in line.find("header"):
        counters = [
            Counter(item_of(line, group.counter), item_of(line, group.step), line.text[group.mode.start] in "rR")
            for group in groups(part)
            if (group.counter.kind, group.mode.kind) == ("VARIABLE", "MODE")
        ]
        if len(counters) == len(groups(part)) and all(map(_is_sound, counters)):
            return _loop(at, counters, bracket.span, behind, beyond)
    return Node(at, lambda env, calls: ((behind, env), (beyond, env)), condition=bracket.span)


class Counter(NamedTuple):
    """A variable of a loop with its maxStep."""

    total: Item
    step: Item
    relative: bool


class Outside(NamedTuple):
    """A key for what holds outside of a loop meanwhile. ``of``: the variable, or the order in which it stands."""

    head: int
    of: Key


def _loop(at: int, counters: Sequence[Counter], span: Span, behind: int, beyond: int) -> Node:
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
            return ((beyond, env),)
        counted = {counter.total.name for counter in counters}
        inside = {key: value for key, value in env.items() if not (isinstance(key, Order) and key.is_of(counted))}
        inside.update((Outside(at, key), value) for key, value in env.items() if key not in inside)
        inside.update((Outside(at, counter.total.name), total) for counter, total in zip(counters, totals))
        for counter, total in zip(counters, totals):
            inside[counter.total.name] = _counted(total, counter, env)
        skipped = ((beyond, env),) if all(map(may_be_zero, totals)) else ()
        return ((behind, inside), *skipped)

    return Node(at, entered, used, condition=span, remark=lambda: remarks[0] if remarks else None)


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


def _closed(head: int, behind: int) -> Callable[[Env, Calls], Flows]:
    """The end of a block: behind a loop its variables are again what they were."""

    def restored(env: Env, calls: Calls) -> Flows:
        saved = {key.of: value for key, value in env.items() if isinstance(key, Outside) and key.head == head}
        if not saved:
            return ((behind, env),)
        counted = {name for name in saved if isinstance(name, str)}
        left = {key: value for key, value in env.items() if not _is_inside(key, head, counted)}
        return ((behind, {**left, **saved}),)

    return restored


def _is_inside(key: Key, head: int, counted: set[str]) -> bool:
    """Whether something is known in a loop only."""
    if isinstance(key, Order):
        return key.is_of(counted)
    return isinstance(key, Outside) and key.head == head


def _words(at: int, line: LineNode, behind: int) -> Node:
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
        return ((behind, env),)

    return Node(at, filled, frozenset(variable for variable, _ in signed), condition=signed[0][1] if signed else None)
