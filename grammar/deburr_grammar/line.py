"""A line and what it was read as: a pure function of dialect, reading and text. Columns only, never a line number."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import TYPE_CHECKING, NamedTuple
from weakref import WeakValueDictionary

from deburr_grammar.problem import Problem
from deburr_grammar.tree import Node, moved, walk

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr_grammar.dialect import Dialect, Reading
    from deburr_grammar.grammar import Parsed

LONGEST = 20_000
DEEPEST = 200
"""A line of more characters or more opening signs than these is not read: no control takes one, and no person wrote it."""
ABSURD = 10 * LONGEST
"""A line of more characters than this is not even folded."""
_OPENING = re.compile(r"[\[(<]")


@dataclass(frozen=True, slots=True)
class Facts:
    """What is kept of a shape's parse: its problems in columns of the shape, and the kinds of node and token in it."""

    problems: tuple[Problem, ...]
    kinds: frozenset[str]


class Shape:
    """A line's text with what does not matter to its syntax folded away. Equal shapes are one object within a dialect."""

    __slots__ = ("__weakref__", "_facts", "dialect", "marked", "memo", "needs_depth", "text")

    def __init__(self, dialect: Dialect, text: str) -> None:
        self.dialect = dialect
        self.text = text
        self.marked = len(text) <= LONGEST and dialect.marks.search(text) is not None
        self.needs_depth = self.marked and dialect.needs_depth.search(text) is not None
        self._facts: dict[str, Facts] = {}
        self.memo: dict[object, object] = {}
        """Room for what others derive from a shape alone."""

    def facts(self, reading: Reading) -> Facts:
        """What this shape is under a reading, parsed once."""
        facts = self._facts.get(reading.name)
        if facts is None:
            facts = self._facts[reading.name] = self._read(reading)
        return facts

    @property
    def readable(self) -> bool:
        """Whether the line is of a length and depth that a program could have."""
        return not self._beyond()

    def _beyond(self) -> str:
        """Which limit the line is beyond."""
        if len(self.text) > LONGEST:
            return "line-too-long"
        return "line-too-deep" if len(_OPENING.findall(self.text)) > DEEPEST else ""

    def tree(self, reading: Reading) -> Node:
        """The tree in columns of the shape; recently used ones are kept."""
        return _parse(self.dialect, reading, self.text).tree

    def _read(self, reading: Reading) -> Facts:
        if reading.start is None:
            return _NOTHING
        if beyond := self._beyond():
            return Facts((Problem(beyond, 0, len(self.text)),), frozenset())
        parsed = _parse(self.dialect, reading, self.text)
        if parsed.deep:
            return Facts((Problem("line-too-deep", 0, len(self.text)),), frozenset())
        problems = () if parsed.fault is None else (self.dialect.diagnose(parsed.fault),)
        return Facts(problems, _interned(frozenset(part.kind for part in walk(parsed.tree))))


_NOTHING = Facts((), frozenset())
_EMPTY = Node("", 0, 0, ())


@lru_cache(maxsize=8192)
def _parse(dialect: Dialect, reading: Reading, text: str) -> Parsed:
    assert reading.start is not None
    return dialect.grammar.parse(reading.start, text)


class _Nodes(NamedTuple):
    """The nodes of a shape in reading order, and those of each kind."""

    all: tuple[Node, ...]
    by_kind: dict[str, list[Node]]


@lru_cache(maxsize=4096)
def _nodes(dialect: Dialect, reading: Reading, text: str) -> _Nodes:
    nodes = tuple(part for part in walk(_parse(dialect, reading, text).tree) if isinstance(part, Node))
    by_kind: dict[str, list[Node]] = {}
    for node in nodes:
        by_kind.setdefault(node.kind, []).append(node)
    return _Nodes(nodes, by_kind)


@lru_cache(maxsize=4096)
def _interned(kinds: frozenset[str]) -> frozenset[str]:
    return kinds


class Shapes(dict[str, Shape]):
    """The shapes of a dialect that are in use, and some that were read last; of the others, those stay that somebody holds."""

    LIMIT = 1_024
    """So many are held by the table itself, and at most as many that were read before them."""

    def __init__(self, dialect: Dialect) -> None:
        super().__init__()
        self._dialect = dialect
        self._before: dict[str, Shape] = {}
        self._older: WeakValueDictionary[str, Shape] = WeakValueDictionary()

    def __missing__(self, text: str) -> Shape:
        if len(self) >= self.LIMIT:
            self._older.update(self._before)
            self._before = self.copy()
            self.clear()
        shape = self._before.get(text) or self._older.get(text)
        if shape is None:
            shape = Shape(self._dialect, text)
        self[text] = shape
        return shape

    def read(self, text: str) -> list[Shape]:
        """The shapes of all lines of a text whose line endings are newlines."""
        if len(text) > ABSURD and max(map(len, lines := text.split("\n"))) > ABSURD:
            return [self[self._folded(line)] for line in lines]
        return list(map(self.__getitem__, self._dialect.folding.fold(text).split("\n")))

    def _folded(self, line: str) -> str:
        # The start says enough of a line that is too long to be read.
        return self._dialect.folding.fold(line) if len(line) <= ABSURD else line[: LONGEST + 1]


@cache
def shapes_of(dialect: Dialect) -> Shapes:
    """The shapes of a dialect; one table for all documents."""
    return Shapes(dialect)


class LineNode:
    """One line: its text without the ending, its reading, its tree and its problems, in columns of the line."""

    __slots__ = ("_columns", "_tree", "reading", "shape", "text")

    def __init__(self, text: str, reading: Reading, shape: Shape) -> None:
        self.text = text
        self.reading = reading
        self.shape = shape
        self._tree: Node | None = None
        self._columns: list[int] | None = None

    @property
    def dialect(self) -> Dialect:
        """The language the line is written in."""
        return self.shape.dialect

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of all nodes and tokens in the tree."""
        return self.shape.facts(self.reading).kinds

    @property
    def tree(self) -> Node:
        """The tree; of a faulty line, what was read before the fault. Empty where the reading reads nothing."""
        if self._tree is None:
            reads = self.reading.start is not None and self.shape.readable
            self._tree = self._moved(self.shape.tree(self.reading)) if reads else _EMPTY
        return self._tree

    @property
    def problems(self) -> tuple[Problem, ...]:
        """The line's syntax faults from left to right."""
        problems = self.shape.facts(self.reading).problems
        if not problems:
            return ()
        if not self.shape.readable:
            return tuple(Problem(p.kind, 0, len(self.text)) for p in problems)
        to_line = self.dialect.folding.columns(self.text)
        return tuple(Problem(p.kind, to_line(p.start), to_line(p.end), p.expected) for p in problems)

    def find(self, *kinds: str) -> Iterator[Node]:
        """All nodes of the given kinds, in reading order."""
        if self.kinds.isdisjoint(kinds):
            return iter(())
        found = _nodes(self.dialect, self.reading, self.shape.text)
        if len(kinds) == 1:
            return map(self._moved, found.by_kind.get(kinds[0], ()))
        return (self._moved(node) for node in found.all if node.kind in kinds)

    def _moved(self, node: Node) -> Node:
        """A part of the shape's tree in columns of the line."""
        if self.text == self.shape.text:
            return node
        if self._columns is None:
            self._columns = self.dialect.folding.columns(self.text).table(len(self.shape.text))
        return moved(node, self._columns.__getitem__)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, LineNode):
            return NotImplemented
        return (self.dialect.name, self.reading, self.text) == (other.dialect.name, other.reading, other.text)

    def __hash__(self) -> int:
        return hash((self.dialect.name, self.reading, self.text))

    def __repr__(self) -> str:
        return f"LineNode({self.reading.name!r}, {self.text!r})"
