"""A line's text, asked for by the parts of its shape's tree, which all lines of a shape share. Calculates nothing."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from deburr.arithmetic.z32 import constant
from deburr.values.domain import Value, exactly
from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, moved

if TYPE_CHECKING:
    from deburr_grammar.line import LineNode


class Text:
    """The text of one line. Parts are those of its shape's tree."""

    __slots__ = ("_node", "_to", "literals")

    def __init__(self, node: LineNode) -> None:
        self._node = node
        self.literals: dict[int, Value] = {}
        """The numbers that were asked for, by the columns of the shape in which they start."""
        self._to: list[int] | None = None

    def said(self, part: Node | Token) -> str:
        """What a part says."""
        start, end = self.span(part)
        return self._node.text[start:end]

    def span(self, part: Node | Token) -> Span:
        """The columns of a part in the line."""
        to = self._columns()
        return Span(to[part.start], to[part.end])

    def literal(self, part: Token) -> Value:
        """The value of a number that is written out; `NOTHING` but wild if it is beyond the largest one."""
        written = math.pi if part.kind == "PI" else number(self.said(part))
        found = self.literals[part.start] = exactly(written)
        return found

    def constant(self, part: Node | Token) -> float | None:
        """The value of an expression if it follows from the line alone, and the control can calculate it."""
        to = self._columns().__getitem__
        here = moved(part, to) if isinstance(part, Node) else Token(part.kind, to(part.start), to(part.end))
        found = constant(self._node.text, here)
        return found if isinstance(found, float) else None

    def _columns(self) -> list[int]:
        if self._to is None:
            shape = self._node.shape.text
            self._to = self._node.dialect.folding.columns(self._node.text).table(len(shape))
        return self._to
