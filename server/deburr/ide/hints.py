"""What is shown within lines: what a word stands for where that is certain."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.symbols import language_of
from deburr.symbols.index import on_line

if TYPE_CHECKING:
    from deburr.ide.view import View


class Hint(NamedTuple):
    """A text behind a place, and the kind under which it can be switched off."""

    line: int
    col: int
    text: str
    kind: str


def hints(view: View, first: int, last: int) -> Iterator[Hint]:
    """The hints of some lines, both included."""
    language = language_of(view.dialect.name)
    for line in range(max(0, first), min(last, view.document.line_count - 1) + 1) if language is not None else ():
        for mention in on_line(view.document, line):
            meant = language.meant(view.document, line, mention) if language is not None else None
            if meant is not None:
                yield Hint(line, mention.span.end, f"={meant.text}", meant.kind)
