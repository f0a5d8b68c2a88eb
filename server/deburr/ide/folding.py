"""Which lines an editor can fold away: regions, blocks, and runs of comments."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.blocks import scopes
from deburr.symbols import Act, Sort
from deburr.symbols.index import all_symbols, mentions_of

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.document import Document

_COMMENTS = 3
"""So many lines of comments in a row are worth folding."""


class Fold(NamedTuple):
    """Lines from the first, which stays, to the last; ``comment``: nothing else stands in them."""

    first: int
    last: int
    comment: bool = False


def folds(view: View) -> list[Fold]:
    """All folds of a program, in order."""
    found = {*_blocks(view.document), *_sections(view.document), *_comments(view.document)}
    return sorted(found)


def _blocks(document: Document) -> Iterator[Fold]:
    for scope in scopes(document.brackets()):
        if scope.start is not None:
            last = scope.end.line if scope.end is not None else document.line_count - 1
            if last > scope.start.line:
                yield Fold(scope.start.line, last)
        for block in scope.blocks:
            if block.closer is not None and block.closer.line > block.opener.line:
                yield Fold(block.opener.line, block.closer.line)


def _sections(document: Document) -> Iterator[Fold]:
    """Sections that have no end: each goes on to the next one, without the empty lines before that."""
    regions = {line for line, _ in document.brackets()}
    placed = (
        each for symbol in all_symbols(document, Sort.SECTION) for each in mentions_of(document, symbol, act=Act.DEFINE)
    )
    starts = sorted({each.line for each in placed} - regions)
    for first, following in zip(starts, [*starts[1:], document.line_count]):
        last = following - 1
        while last > first and not document.line(last).strip():
            last -= 1
        if last > first:
            yield Fold(first, last)


def _comments(document: Document) -> Iterator[Fold]:
    signs = tuple(opens for opens, _ in document.dialect.comments)
    first = at = 0
    run = 0
    for chunk in document.chunks():
        held = any(sign in chunk.text for sign in signs)
        for text in chunk.lines[: chunk.eols] if held else ():
            if text.lstrip(" \t").startswith(signs):
                first, run = (first, run + 1) if run else (at, 1)
            else:
                yield from _run(first, run)
                run = 0
            at += 1
        if not held:
            yield from _run(first, run)
            run = 0
            at += chunk.eols
    # Only the last chunk has a line without an end.
    if document.line(at).lstrip(" \t").startswith(signs):
        first, run = (first, run + 1) if run else (at, 1)
    yield from _run(first, run)


def _run(first: int, count: int) -> Iterator[Fold]:
    if count >= _COMMENTS:
        yield Fold(first, first + count - 1, True)
