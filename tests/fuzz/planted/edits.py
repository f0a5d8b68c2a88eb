"""The parser with a fault: an edit behind the third line that brings a bracket is lost."""

from __future__ import annotations

from deburr_grammar.document import Document
from deburr_grammar.text import Edit
from fuzz.targets import parser

seeds = parser.seeds


def run(data: bytes) -> None:
    """As the parser's target."""
    right = Document.edit

    def wrong(self: Document, *edits: Edit) -> Document:
        lost = len(edits) == 1 and "]" in edits[0].text and edits[0].start.line >= 3
        return self if lost else right(self, *edits)

    Document.edit = wrong  # type: ignore[method-assign]
    try:
        parser.run(data)
    finally:
        Document.edit = right  # type: ignore[method-assign]
