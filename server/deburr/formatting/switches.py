"""Comments that keep lines from being laid out: from `deburr: format off` to `deburr: format on`, both included."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING

from deburr.suppress import comment_pattern

if TYPE_CHECKING:
    from deburr_grammar.dialect import Dialect
    from deburr_grammar.document import Document, Piece

_SIGN = "deburr:"
_KEY = "format switches"


class Switches:
    """Which lines of a document are to be left alone. Looks only at pieces with such comments."""

    def __init__(self, document: Document) -> None:
        self._starts: list[int] = []
        """Where stretches start, by turns those that are laid out no more and those that are again."""
        for line, off in _switches(document):
            if off is not bool(len(self._starts) % 2):
                self._starts.append(line if off else line + 1)

    def off(self, line: int) -> bool:
        """Whether a line is to be left alone."""
        return bisect_right(self._starts, line) % 2 == 1


def _switches(document: Document) -> Iterator[tuple[int, bool]]:
    """The lines of such comments, and whether they switch off; of several on a line the last."""
    dialect = document.dialect

    def held(piece: Piece) -> frozenset[bool]:
        there = _SIGN in piece.chunk.text and any(_said(text, dialect) for text in piece.chunk.lines)
        return frozenset((True,)) if there else frozenset()

    for piece in document.holding(_KEY, held, True):
        for index, text in enumerate(piece.chunk.lines):
            if found := _said(text, dialect):
                yield piece.line + index, found[-1]


def _said(text: str, dialect: Dialect) -> list[bool]:
    if _SIGN not in text:
        return []
    return ["off" in match.groups() for match in _pattern(dialect).finditer(text)]


@cache
def _pattern(dialect: Dialect) -> re.Pattern[str]:
    return re.compile(comment_pattern(dialect.comments, rf"{_SIGN}[ \t]*format[ \t]+(off|on)(?![\w-]){{}}*"))
