"""What a line was read as: tokens and nodes with columns. Never holds a line number."""

from collections.abc import Callable, Iterator
from typing import NamedTuple, Union


class Token(NamedTuple):
    """A terminal of the line grammar: its name and its columns."""

    kind: str
    start: int
    end: int


class Node(NamedTuple):
    """A rule of the line grammar: its name, its columns from first to last token, its parts."""

    kind: str
    start: int
    end: int
    children: tuple[Union["Node", Token], ...]

    def find(self, kind: str) -> Union["Node", Token, None]:
        """The first direct part of that kind."""
        return next((child for child in self.children if child.kind == kind), None)

    def node(self, kind: str) -> Union["Node", None]:
        """The first direct part of that kind that is a node."""
        return next((child for child in self.children if isinstance(child, Node) and child.kind == kind), None)

    def nodes(self) -> Iterator["Node"]:
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
    kind, start, end, children = tree
    parts = [
        moved(child, to) if isinstance(child, Node) else Token(child.kind, to(child.start), to(child.end))
        for child in children
    ]
    return Node(kind, to(start), to(end), tuple(parts))
