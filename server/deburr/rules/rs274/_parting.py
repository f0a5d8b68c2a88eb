"""Fixes of words that exclude each other on a line. They never choose between two: only who wrote both knows which was meant."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.fixers import deleted, parted
from deburr.rule import Line
from deburr.rules.rs274._words import Words, said, words

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.finding import Fix
    from deburr.fix import Broken


def line_of(broken: Broken) -> tuple[Line, Words, list[int]]:
    """The line of a fault, its words, and where they start."""
    line = Line(broken.node, broken.analysis.settings)
    return line, words(line), [word.start for word in broken.node.find("word")]


def copy_left_out(broken: Broken) -> Iterator[Fix]:
    """A word that stands on the line before, with the same code or spelled alike, is left out."""
    line, found, starts = line_of(broken)
    at = starts.index(broken.span.start)
    same = [_meaning(line, found, each) for each in range(at + 1)]
    if same[at] in same[:at]:
        yield from deleted(broken)


def _meaning(line: Line, found: Words, at: int) -> str:
    return found.codes[at] or "".join(said(line, at).split()).upper()


def between(broken: Broken, other: int) -> Iterator[Fix]:
    """The line is split between the fault and another of its words, where each has axis words of its own."""
    _, found, starts = line_of(broken)
    if "setting" not in broken.node.kinds:
        # What a line sets holds behind it, so that two lines would read other values.
        yield from parted(broken, list(zip(found.letters, starts)), starts.index(broken.span.start), other)


def group_parted(broken: Broken) -> Iterator[Fix]:
    """Split between the fault and the code of its modal group before it."""
    _, found, starts = line_of(broken)
    at = starts.index(broken.span.start)
    before = [each for group in found.groups.values() if at in group for each in group if each < at]
    if before:
        yield from between(broken, before[-1])
