"""What a line was read as: tokens and nodes with columns. Never holds a line number."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple, Union


class Token(NamedTuple):
    """A terminal of the line grammar: its name and its columns."""

    kind: str
    start: int
    end: int


class Node:
    """A rule of the line grammar: its name, its columns from first to last token, its parts. Never changed once it is made.

    One that was `moved` moves its parts when they are asked for: of most nodes of a line only the columns are.
    """

    __slots__ = ("_children", "_to", "end", "kind", "start")

    def __init__(
        self,
        kind: str,
        start: int,
        end: int,
        children: tuple[Union[Node, Token], ...],
        to: Callable[[int], int] | None = None,
    ) -> None:
        self.kind = kind
        self.start = start
        self.end = end
        self._children = children
        self._to = to

    @property
    def children(self) -> tuple[Union[Node, Token], ...]:
        """The parts from left to right."""
        if (to := self._to) is not None:
            self._children = tuple(
                [
                    _token((child[0], to(child[1]), to(child[2]))) if isinstance(child, tuple) else moved(child, to)
                    for child in self._children
                ]
            )
            self._to = None
        return self._children

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Node):
            return NotImplemented
        return (self.kind, self.start, self.end, self.children) == (other.kind, other.start, other.end, other.children)

    def __hash__(self) -> int:
        return hash((self.kind, self.start, self.end, self.children))

    def __repr__(self) -> str:
        return f"Node({self.kind!r}, {self.start}, {self.end}, {self.children!r})"

    def find(self, kind: str) -> Union[Node, Token, None]:
        """The first direct part of that kind."""
        return next((child for child in self.children if child.kind == kind), None)

    def node(self, kind: str) -> Union[Node, None]:
        """The first direct part of that kind that is a node."""
        return next((child for child in self.children if isinstance(child, Node) and child.kind == kind), None)

    def nodes(self) -> Iterator[Node]:
        """The direct parts that are nodes."""
        return (child for child in self.children if isinstance(child, Node))


def walk(tree: Node | Token) -> Iterator[Node | Token]:
    """The tree in reading order, each node before its parts."""
    waiting = [tree]
    while waiting:
        part = waiting.pop()
        yield part
        if isinstance(part, Node):
            waiting += part.children[::-1]


def tokens(tree: Node | Token) -> Iterator[Token]:
    """The tree's tokens from left to right."""
    return (part for part in walk(tree) if isinstance(part, Token))


def moved(tree: Node, to: Callable[[int], int]) -> Node:
    """The same tree with every column sent through ``to``."""
    return Node(tree.kind, to(tree.start), to(tree.end), tree.children, to)


_token: Callable[[tuple[str, int, int]], Token] = partial(tuple.__new__, Token)
"""A token of its fields, made without the call of Python that its name costs."""
