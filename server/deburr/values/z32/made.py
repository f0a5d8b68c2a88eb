"""What is made of a line's text once, for all lines of a program that say the same: its fields, and what calculates them. Knows no line's place.

Lines that differ only in their numbers share what is compiled; each keeps what came of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeVar

from deburr.values.kept import LINES
from deburr.values.z32.expressions import Expressions, World
from deburr.values.z32.text import Text
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.line import LineNode, Shape

T = TypeVar("T")
Bind = Callable[[Text], T]
"""What makes of a text what was compiled for its shape."""
_LONGEST = 300
"""A number of no more characters is not beyond the largest one."""
_READING = frozenset(("NAME", "other", "alias_name", "vector"))
_CALCULATING = frozenset(("sum", "product", "function"))


class Made:
    """The parts of one line's text, which are those of its shape's tree."""

    def __init__(self, world: World, node: LineNode) -> None:
        self._world = world
        self._node = node
        self.text = Text(node)
        self.groups = groups_of(node.shape, node.reading)
        """Its fields."""
        fields = [each for group in self.groups for each in group]
        self.fields = len(fields)
        """How many fields there are."""
        self.ranges = [each for each in fields if each.kind == "jump" and each.node("range_end")]
        """The jumps that return."""
        self._parts: dict[int, tuple[Expressions, Any]] = {}

    def part(self, number: int, make: Callable[[Expressions], Bind[T]]) -> tuple[Expressions, T]:
        """What ``make`` makes of a part of the shape, for this line, and the expressions in it: made once."""
        found = self._parts.get(number)
        if found is None:
            shared = _compiled(self._world, self._node.reading, self._node.shape.text, _key(self._node, self.text))
            if number not in shared:
                expressions = Expressions(self.text, self._world)
                shared[number] = expressions, make(expressions)
            expressions, bind = shared[number]
            found = self._parts[number] = expressions, bind(self.text)
        return found


@lru_cache(maxsize=LINES)
def made(world: World, node: LineNode) -> Made:
    """What is made of a line."""
    return Made(world, node)


def groups_of(shape: Shape, reading: Reading) -> Sequence[Sequence[Node]]:
    """The fields of the advanced lines of a shape, between `!` and `!`; none of blocks."""
    key = ("z32 fields", reading.name)
    found: Any = shape.memo.get(key)
    if found is None:
        tree = shape.tree(reading) if "advanced" in shape.facts(reading).kinds else None
        found = shape.memo[key] = fields_of(tree) if tree is not None else []
    groups: Sequence[Sequence[Node]] = found
    return groups


def fields_of(tree: Node) -> list[list[Node]]:
    """The fields in the tree of an advanced line, between `!` and `!`."""
    found: list[list[Node]] = []
    line = next((part for part in walk(tree) if isinstance(part, Node) and part.kind == "advanced"), None)
    for part in line.children if line is not None else ():
        if isinstance(part, Node):
            found[-1].append(part)
        elif part.kind == "BANG":
            found.append([])
    return [fields for fields in found if fields]


@lru_cache(maxsize=LINES)
def _compiled(
    world: World, reading: Reading, shape: str, said: tuple[str, ...]
) -> dict[int, tuple[Expressions, Bind[Any]]]:
    """What was compiled of the parts of a shape. ``said``: those of its numbers that decide more than a value."""
    return {}


def _key(node: LineNode, text: Text) -> tuple[str, ...]:
    """What a line says that decides more than values."""
    key = ("z32 numbers that decide", node.reading.name)
    if key not in node.shape.memo:
        node.shape.memo[key] = _deciding(node.shape, node.shape.tree(node.reading))
    deciding: Any = node.shape.memo[key]
    if deciding is None or len(node.text) > _LONGEST:
        return (node.text,)
    return tuple([text.said(part) for part in deciding])


def _deciding(shape: Shape, tree: Node) -> Sequence[Token] | None:
    """Numbers that decide more than a value: which element is meant. None: any may, as that of an M code, or whether the control can calculate what reads nothing."""
    nodes = [part for part in walk(tree) if isinstance(part, Node)]
    if any(_is_told_by_numbers(shape.text, part) for part in nodes):
        return None
    return list(_indices(nodes))


def _is_told_by_numbers(text: str, part: Node) -> bool:
    if part.kind == "word":
        target = part.children[0]
        return text[target.start : target.end].upper() == "M"
    return part.kind in _CALCULATING and all(each.kind not in _READING for each in walk(part))


def _indices(nodes: Sequence[Node]) -> Iterator[Token]:
    for part in nodes:
        if part.kind == "vector" and isinstance(index := part.children[2], Token):
            yield index
