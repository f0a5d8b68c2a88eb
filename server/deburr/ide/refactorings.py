"""The ways to rebuild a program that an editor offers at a place: what could be done is seen from the line alone, and proven when it is to be done."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.fix import as_one, in_endings
from deburr.ide.extract import could_extract, extracted
from deburr.ide.fixes import fix_all
from deburr.ide.inline import could_inline, inlined
from deburr.ide.refactor import Cannot, Work, moves_of
from deburr.ide.renumber import renumbered_blocks, renumbered_lines

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    from deburr.ide.refactor import NewFile
    from deburr.ide.view import View
    from deburr_grammar.text import Edit, Pos

FIX_ALL = "source.fixAll.deburr"
MOST = 10_000
"""Edits that are handed out one by one; more of them are one edit, which editors take more easily."""


class Offer(NamedTuple):
    """What could be done: its title, its kind as the protocol has it, its name in `rebuilt`."""

    title: str
    kind: str
    name: str


class Rebuilt(NamedTuple):
    """The edits of the program, and the file that it then needs."""

    edits: tuple[Edit, ...]
    file: NewFile | None = None


def offers(view: View, start: Pos, end: Pos) -> Iterator[Offer]:
    """What could be done with a selection, or at a place: looks at the first line of it alone."""
    moves = moves_of(view.dialect.name)
    if start.line >= view.document.line_count or moves is None:
        return
    node = view.document.node(start.line)
    if moves.LINES is not None and any(moves.line_numbers(node)):
        yield Offer("Renumber all lines", "refactor.rewrite", "renumber-lines")
    if moves.BLOCKS is not None and any(each.symbol.name for each in moves.block_numbers(node)):
        yield Offer("Renumber all blocks", "refactor.rewrite", "renumber-blocks")
    if name := could_inline(view, start):
        yield Offer(f"Put the value of `{name}` in its place", "refactor.inline", "inline")
    if what := could_extract(view, start, end):
        yield Offer(f"Extract to a {what}", "refactor.extract", "extract")


def everything() -> Offer:
    """All safe fixes."""
    return Offer("Fix all that is safe to fix", FIX_ALL, "fix-all")


def rebuilding(view: View, name: str, start: Pos, end: Pos) -> Work[Rebuilt]:
    """Do what was offered, in steps; Cannot where it would change what the program means, or is nothing that there is."""
    if name == "extract":
        found = yield from extracted(view, start, end)
        return Rebuilt(in_endings(view.document, sorted(found.edits)), found.file)
    plain: Mapping[str, Callable[[], Work[tuple[Edit, ...]]]] = {
        "renumber-lines": lambda: renumbered_lines(view),
        "renumber-blocks": lambda: renumbered_blocks(view),
        "inline": lambda: inlined(view, start),
        "fix-all": lambda: fix_all(view),
    }
    if name not in plain:
        raise Cannot(f"`{name}` is nothing that can be done")
    edits = yield from plain[name]()
    edits = in_endings(view.document, sorted(edits))
    return Rebuilt(edits if len(edits) <= MOST else (as_one(view.document, edits),))


def rebuilt(view: View, name: str, start: Pos, end: Pos) -> Rebuilt:
    """The same at once."""
    work = rebuilding(view, name, start, end)
    while True:
        try:
            next(work)
        except StopIteration as done:
            found: Rebuilt = done.value
            return found
