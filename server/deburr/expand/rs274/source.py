"""The line whose values are being calculated: where it stands, and where on it the parts of its tree do. Calculates nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr_grammar.line import Shape
    from deburr_grammar.tree import Node, Token


class Source:
    """One line at a time. ``shape``: the tree is that of the shape, in columns of which it is."""

    __slots__ = ("file", "row", "shape", "text")

    def __init__(self, file: str, row: int, text: str, shape: Shape | None = None) -> None:
        self.file = file
        self.row = row
        self.text = text
        self.shape = shape

    @property
    def sample(self) -> str:
        """A text that differs from the line's in digits and comments at most, in columns of which the tree is."""
        return self.text if self.shape is None else self.shape.text

    def span(self, part: Node | Token) -> Span:
        """Where a part stands on the line."""
        if self.shape is None:
            return Span(part.start, part.end)
        column = self.shape.dialect.folding.columns(self.text)
        return Span(column(part.start), column(part.end))

    def said(self, part: Node | Token) -> str:
        """The text of a part."""
        start, end = self.span(part)
        return self.text[start:end]


class Spot(NamedTuple):
    """A part of the line at hand. Its place is looked up when it is asked for: most parts are never at fault."""

    source: Source
    part: Node | Token
