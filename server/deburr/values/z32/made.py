"""What is made of a line's text once, for all lines of a program that say the same: its fields, and what calculates them. Knows no line's place."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, TypeVar

from deburr.values.kept import LINES
from deburr.values.z32.expressions import Expressions, World
from deburr_grammar.tree import Node

if TYPE_CHECKING:
    from deburr_grammar.line import LineNode

T = TypeVar("T")


class Made:
    """The parts of one line's text."""

    def __init__(self, world: World, node: LineNode) -> None:
        self._world = world
        self._text = node.text
        self.groups = fields_of(node)
        """Its fields."""
        self.ranges = (
            [each for each in node.find("jump") if each.node("range_end")] if "range_end" in node.kinds else []
        )
        """The jumps that return."""
        self._parts: dict[int, tuple[Expressions, Any]] = {}

    @property
    def fields(self) -> int:
        """How many fields there are."""
        return sum(map(len, self.groups))

    def part(self, number: int, make: Callable[[Expressions], T]) -> tuple[Expressions, T]:
        """What ``make`` makes of a part of the line, and the expressions in it: made once."""
        found = self._parts.get(number)
        if found is None:
            expressions = Expressions(self._text, self._world)
            found = self._parts[number] = expressions, make(expressions)
        return found


@lru_cache(maxsize=LINES)
def made(world: World, node: LineNode) -> Made:
    """What is made of a line."""
    return Made(world, node)


def fields_of(node: LineNode) -> list[list[Node]]:
    """The fields of an advanced line between `!` and `!`; none of a block."""
    found: list[list[Node]] = []
    line = next(node.find("advanced"), None) if "advanced" in node.kinds else None
    for part in line.children if line is not None else ():
        if isinstance(part, Node):
            found[-1].append(part)
        elif part.kind == "BANG":
            found.append([])
    return [fields for fields in found if fields]
