"""A stretch of whole lines and the tree of stretches. Immutable; never holds an absolute line or offset.

The document is a B-tree of chunks of some 8 KB. Every node keeps how many line ends and
characters it spans and, lazily, whatever is derived from its text alone. An edit makes new
nodes on one path from leaf to root and shares the rest, so its cost does not grow with the
file, and the sums of all untouched nodes stay known.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import compress, count
from operator import sub
from typing import Any, NamedTuple

from deburr_grammar.line import Shape, Shapes
from deburr_grammar.text import line_starts, split_lines, with_newlines

SIZE = 8_192
FANOUT = 8


class Former(NamedTuple):
    """What is known of a chunk that an edit changed: its marked lines, what was derived from it, and from which line to which it was changed, both included."""

    marked: array[int]
    memo: dict[Any, Any]
    first: int
    last: int


class Chunk:
    """Whole lines of text. Only the last chunk of a document may have a tail behind its last line end."""

    __slots__ = (
        "_distinct",
        "_marked",
        "_needs_depth",
        "_shapes",
        "_starts",
        "chars",
        "eols",
        "former",
        "memo",
        "table",
        "text",
    )

    def __init__(
        self, text: str, table: Shapes, starts: array[int] | None = None, shapes: list[Shape] | None = None
    ) -> None:
        self.text = text
        self.table = table
        self.chars = len(text)
        self._starts = starts
        self._shapes = shapes
        self.eols = _count_ends(text) if starts is None else len(starts) - 1
        self.memo: dict[Any, Any] = {}
        """Room for what is derived from this chunk alone, under keys that name all else that went in."""
        self.former: Former | None = None
        """What it was before an edit, until somebody has read it."""
        self._distinct: tuple[Shape, ...] | None = None
        self._marked: array[int] | None = None
        self._needs_depth: bool | None = None

    @property
    def starts(self) -> array[int]:
        """Offsets of the line starts; the last is that of the tail."""
        if self._starts is None:
            self._starts = line_starts(self.text)
        return self._starts

    def line(self, index: int) -> str:
        """A line's text without its ending."""
        starts = self.starts
        if index + 1 < len(starts):
            return self.text[starts[index] : starts[index + 1]].rstrip("\r\n")
        return self.text[starts[index] :]

    def ending(self, index: int) -> str:
        """A line's ending; the tail has none."""
        starts = self.starts
        line = self.text[starts[index] : starts[index + 1]] if index + 1 < len(starts) else ""
        return line[len(line.rstrip("\r\n")) :]

    @property
    def lines(self) -> list[str]:
        """All lines without their endings, the tail included. Made anew each time: they would weigh more than the text."""
        return split_lines(self.text)

    @property
    def lengths(self) -> list[int]:
        """How long each line is with its ending, the tail included."""
        starts = self.starts
        return [*map(sub, starts[1:], starts), self.chars - starts[-1]]

    @property
    def shapes(self) -> list[Shape]:
        """The shape of every line, and of the tail if there is one."""
        if self._shapes is None:
            found = self.table.read(with_newlines(self.text))
            if not self.text or self.text[-1] in "\r\n":
                found.pop()
            self._shapes = found
        return self._shapes

    @property
    def known_shapes(self) -> list[Shape] | None:
        """The shapes, if they have been asked for before."""
        return self._shapes

    @property
    def distinct(self) -> tuple[Shape, ...]:
        """Each shape once. There are few, so what hangs on shapes alone is asked of them and not of the lines."""
        if self._distinct is None:
            self._distinct = tuple(set(self.shapes))
        return self._distinct

    def where(self, shapes: set[Shape], start: int = 0, stop: int | None = None) -> Iterator[int]:
        """The numbers of the lines of some shapes, of those from ``start`` up to ``stop``."""
        among = self.shapes if not start and stop is None else self.shapes[start:stop]
        return compress(count(start), map(shapes.__contains__, among)) if shapes else iter(())

    @property
    def marked(self) -> array[int]:
        """The numbers of the lines that must be shown to the outline."""
        if self._marked is None:
            self._marked = array("I", self.where({shape for shape in self.distinct if shape.marked}))
        return self._marked

    @property
    def needs_depth(self) -> bool:
        """Whether any line asks how deep it stands."""
        if self._needs_depth is None:
            self._needs_depth = any(shape.needs_depth for shape in self.distinct)
        return self._needs_depth


class Branch:
    """Chunks or branches of equal height, in order."""

    __slots__ = ("__dict__", "chars", "children", "eols", "memo")

    def __init__(self, children: Sequence[Chunk] | Sequence[Branch]) -> None:
        self.children: tuple[Chunk | Branch, ...] = tuple(children)
        self.eols: int = sum(child.eols for child in self.children)
        self.chars: int = sum(child.chars for child in self.children)
        self.memo: dict[Any, Any] = {}

    @cached_property
    def chunks(self) -> int:
        """How many chunks stand below."""
        return sum(child.chunks if isinstance(child, Branch) else 1 for child in self.children)

    @cached_property
    def leaf(self) -> bool:
        """Whether the children are chunks."""
        return isinstance(self.children[0], Chunk)

    @cached_property
    def needs_depth(self) -> bool:
        """Whether any line below asks how deep it stands."""
        return any(child.needs_depth for child in self.children)


def grown(nodes: list[Chunk] | list[Branch]) -> Branch:
    """A tree over nodes of equal height."""
    level = [Branch(group) for group in _groups(list(nodes))]
    while len(level) > 1:
        level = [Branch(group) for group in _groups(level)]
    return level[0]


def chunk_at(root: Branch, index: int) -> Chunk:
    """The chunk of that number."""
    node: Chunk | Branch = root
    while isinstance(node, Branch):
        if node.leaf:
            node = node.children[index]
            continue
        for child in node.children:
            assert isinstance(child, Branch)
            if index < child.chunks:
                node = child
                break
            index -= child.chunks
    return node


def spliced(root: Branch, start: int, stop: int, new: list[Chunk]) -> Branch:
    """The tree with the chunks from ``start`` up to ``stop`` replaced; at least one chunk must be left."""
    branches = _spliced(root, start, stop, new)
    while len(branches) == 1 and not branches[0].leaf and len(branches[0].children) == 1:
        branches = [child for child in branches[0].children if isinstance(child, Branch)]
    return branches[0] if len(branches) == 1 else grown(branches)


def _spliced(node: Branch, start: int, stop: int, new: list[Chunk]) -> list[Branch]:
    if node.leaf:
        kept = [child for child in node.children if isinstance(child, Chunk)]
        kept[start:stop] = new
        return [Branch(group) for group in _groups(kept)]
    children: list[Branch] = []
    at = 0
    placed = False
    for child in node.children:
        assert isinstance(child, Branch)
        first, behind = at, at + child.chunks
        at = behind
        if behind <= start or (first >= stop and placed):
            children.append(child)
            continue
        children += _spliced(child, max(start - first, 0), min(stop, behind) - first, [] if placed else new)
        placed = True
    return [Branch(group) for group in _groups(_merged(children))]


def _merged(branches: list[Branch]) -> list[Branch]:
    """Neighbours that are thin enough to stand in one branch do."""
    merged: list[Branch] = []
    for branch in branches:
        if merged and len(merged[-1].children) + len(branch.children) <= FANOUT // 2:
            merged[-1] = Branch(merged[-1].children + branch.children)  # type: ignore[arg-type]  # equal heights: both hold chunks or both branches
        else:
            merged.append(branch)
    return merged


def _groups(nodes: list[Any]) -> list[list[Any]]:
    if not nodes:
        return []
    count = -(-len(nodes) // FANOUT)
    size = -(-len(nodes) // count)
    return [nodes[at : at + size] for at in range(0, len(nodes), size)]


def _count_ends(text: str) -> int:
    if "\r" not in text:
        return text.count("\n")
    return text.count("\n") + text.count("\r") - text.count("\r\n")
