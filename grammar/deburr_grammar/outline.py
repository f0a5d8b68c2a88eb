"""How the lines of a document are read, and their brackets: one fold over chunks, kept with each chunk. Never re-reads a line.

What a chunk's lines are depends on the state before it (inside a table section, behind the
program's end) and on facts of the whole document. A chunk keeps its answer for each state it
has met, a branch keeps the sum over its children; so a changed state runs on only until it
meets one that is known.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Hashable, Iterator
from functools import lru_cache
from itertools import pairwise
from typing import NamedTuple

from deburr_grammar.chunk import Branch, Chunk
from deburr_grammar.dialect import Bracket, Dialect, Reading, Step
from deburr_grammar.line import LineNode, Shape
from deburr_grammar.structure import EVEN, Balance, Reduction, balance, in_a_row, reduction
from deburr_grammar.text import with_newlines

_KEPT = 64
"""So many answers are kept with a node; of more, those that are the oldest are forgotten."""


class Before(NamedTuple):
    """What holds before a stretch: the outline's state, and the balance of all that precedes it."""

    state: Hashable
    balance: Balance


class Stepped(NamedTuple):
    """A marked line in its place: its number in the chunk, what holds before it, what it does, and what holds behind it."""

    number: int
    before: Before
    step: Step
    after: Before


class Summed(NamedTuple):
    """A branch under a state: its balance, what holds behind it, and what is left of its brackets."""

    balance: Balance
    state: Hashable
    left: Reduction


class Outlined(NamedTuple):
    """A chunk under a state: from which line on which reading holds, its brackets with their lines and what is left of them, what holds behind it, and what its marked lines do."""

    runs: tuple[tuple[int, Reading], ...]
    brackets: tuple[tuple[int, Bracket], ...]
    balance: Balance
    state: Hashable
    left: Reduction
    steps: tuple[Step, ...]

    def reading(self, index: int) -> Reading:
        """How a line of the chunk is read."""
        return next(reading for first, reading in reversed(self.runs) if first <= index)


class Outliner:
    """The fold for one dialect under given facts. Equal facts give equal answers, so these are kept under them."""

    def __init__(self, dialect: Dialect, facts: frozenset[str]) -> None:
        self.dialect = dialect
        self.facts = facts

    @property
    def start(self) -> Before:
        """What holds before the first line."""
        return Before(self.dialect.outline.start(self.facts), EVEN)

    def behind(self, node: Branch | Chunk, before: Before) -> Before:
        """What holds behind a node."""
        found = self._found(node, before)
        return Before(found.state, before.balance.then(found.balance))

    def inner(self, node: Branch, before: Before) -> Iterator[tuple[Branch | Chunk, Before]]:
        """The children of a branch, each with what holds before it. None is read before the one behind it is asked for."""
        yield node.children[0], before
        for child, following in pairwise(node.children):
            before = self.behind(child, before)
            yield following, before

    def balance(self, node: Branch | Chunk, before: Before) -> Balance:
        """The balance of a node's own brackets."""
        return self._found(node, before).balance

    def outlined(self, chunk: Chunk, before: Before) -> Outlined:
        """The lines of a chunk."""
        found = self._found(chunk, before)
        assert isinstance(found, Outlined)
        return found

    def reduction(self, node: Branch | Chunk, before: Before) -> Reduction:
        """A node's brackets with all pairs inside it taken out; lines counted from the node's first."""
        return self._found(node, before).left

    def key(self, node: Branch | Chunk, before: Before) -> Hashable:
        """All that the outline of a node depends on besides its text."""
        return (self.facts, before.state, before.balance.openers if node.needs_depth else -1)

    def keep(self, node: Branch | Chunk, key: Hashable, value: object) -> None:
        """Keep an answer with the node that it is derived from."""
        # One check and the questions about a program leave some forty answers; whichever is left out, the others stay.
        while len(node.memo) >= _KEPT:
            del node.memo[next(iter(node.memo))]
        node.memo[key] = value

    def _found(self, node: Branch | Chunk, before: Before) -> Summed | Outlined:
        key = self.key(node, before)
        found: Summed | Outlined | None = node.memo.get(key)
        if found is None:
            found = self._sum(node, before) if isinstance(node, Branch) else self._read(node, before)
            self.keep(node, key, found)
        return found

    def _sum(self, node: Branch, before: Before) -> Summed:
        state, total, running = before.state, EVEN, before.balance
        parts: list[Reduction] = []
        for child in node.children:
            found = self._found(child, Before(state, running))
            parts.append(found.left)
            state, total, running = found.state, total.then(found.balance), running.then(found.balance)
        return Summed(total, state, in_a_row(parts, tuple(child.eols for child in node.children)))

    def steps(self, chunk: Chunk, before: Before) -> Iterator[Stepped]:
        """The marked lines of a chunk, in order."""
        for index in chunk.marked:
            step = self.step(before, chunk.shapes[index], chunk.line(index))
            after = Before(step.state, before.balance.then(balance(step.brackets)))
            yield Stepped(index, before, step, after)
            before = after

    def step(self, before: Before, shape: Shape, text: str) -> Step:
        """What a marked line does where that holds before it."""
        depth = before.balance.openers if shape.needs_depth else -1
        return _step(self.dialect, self.facts, before.state, depth, shape, text)

    def _read(self, chunk: Chunk, before: Before) -> Outlined:
        outline = self.dialect.outline
        runs, state = [(0, outline.reading(before.state))], before.state
        found: list[tuple[int, Bracket]] = []
        known = self._former(chunk, before)
        steps = tuple(self._steps(chunk, before, known))
        for index, step in zip(chunk.marked, steps):
            state = step.state
            _run(runs, index, step.reading)
            found += [(index, bracket) for bracket in step.brackets]
            _run(runs, index + 1, outline.reading(state))
        # As the same object, what is made of it is found again.
        left = known.left if known is not None and known.brackets == tuple(found) else reduction(found)
        return Outlined(tuple(runs), tuple(found), left.balance, state, left, steps)

    def _former(self, chunk: Chunk, before: Before) -> Outlined | None:
        """What a chunk was before an edit, read under the same state."""
        return None if chunk.former is None else chunk.former.memo.get(self.key(chunk, before))

    def _steps(self, chunk: Chunk, before: Before, known: Outlined | None) -> Iterator[Step]:
        """What the marked lines of a chunk do. Where an edit left a line and the state before it as they were, it does what it did."""
        former, chunk.former = chunk.former, None
        if former is None or known is None or chunk.needs_depth:
            yield from (stepped.step for stepped in self.steps(chunk, before))
            return
        marked, state, shapes = chunk.marked, before.state, chunk.shapes
        above = bisect_left(former.marked, former.first)
        below = bisect_right(former.marked, former.last)
        yield from known.steps[:above]
        state = known.steps[above - 1].state if above else state
        kept = len(marked) - (len(former.marked) - below)
        for number in range(above, len(marked)):
            old = number - kept + below
            if number >= kept and (known.steps[old - 1].state if old else before.state) == state:
                yield from known.steps[old:]
                return
            step = _step(self.dialect, self.facts, state, -1, shapes[marked[number]], chunk.line(marked[number]))
            yield step
            state = step.state


@lru_cache(maxsize=4_096)
def _step(dialect: Dialect, facts: frozenset[str], state: Hashable, depth: int, shape: Shape, text: str) -> Step:
    return dialect.outline.step(state, depth, facts, lambda reading: LineNode(text, reading, shape))


def _run(runs: list[tuple[int, Reading]], index: int, reading: Reading) -> None:
    if runs[-1][1] is reading:
        return
    if runs[-1][0] == index:
        runs.pop()
    if not runs or runs[-1][1] is not reading:
        runs.append((index, reading))


def facts_of(node: Branch | Chunk, dialect: Dialect) -> frozenset[str]:
    """What the text of a node says about the document as a whole."""
    found = node.memo.get("facts")
    if found is None:
        if isinstance(node, Chunk):
            found = dialect.outline.facts(with_newlines(node.text))
        else:
            found = frozenset[str]()
            for child in node.children:
                if facts := facts_of(child, dialect):
                    found |= facts
        node.memo["facts"] = found
    assert isinstance(found, frozenset)
    return found
