"""State that runs along the lines of a program: modal groups, aliases. Folded on demand, kept with each chunk, cut off where it agrees.

A fold's answer for a chunk is kept under the state before it, so after an edit only the
chunks whose incoming state changed are folded again. Never keeps a line number.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Protocol, TypeVar

from deburr_grammar.chunk import Branch, Chunk
from deburr_grammar.dialect import Bracket, Reading
from deburr_grammar.line import LineNode, Shape
from deburr_grammar.outline import Before, Outlined, Outliner

S = TypeVar("S", bound=Hashable)


class Fold(Protocol[S]):
    """A state and how lines change it. States must be cheap to hash: intern what is large."""

    start: S
    only_brackets: bool
    """Whether nothing else than brackets changes it."""

    def plain(self, state: S, reading: Reading, shape: Shape) -> S:
        """The state behind a line without marks: it may depend on the shape alone."""

    def marked(self, state: S, line: LineNode, brackets: Sequence[Bracket]) -> S:
        """The state behind a line that the outline saw."""


def carried(fold: Fold[S], state: S, node: Branch | Chunk, before: Before, outliner: Outliner) -> S:
    """The state behind a node."""
    key = (fold, state, outliner.key(node, before))
    if key not in node.memo:
        if isinstance(node, Branch):
            found = state
            for child, inner in outliner.inner(node, before):
                found = carried(fold, found, child, inner, outliner)
        else:
            found = through(fold, state, node, outliner.outlined(node, before))
        outliner.keep(node, key, found)
        return found
    known: S = node.memo[key]
    return known


def keep(fold: Fold[S], state: S, chunk: Chunk, key: Hashable, behind: S) -> None:
    """Know the state behind a chunk under the one before it; ``key`` is that of its outline."""
    chunk.memo[fold, state, key] = behind


def through(fold: Fold[S], state: S, chunk: Chunk, outlined: Outlined, upto: int | None = None) -> S:
    """The state behind the first ``upto`` lines of a chunk (all lines: None)."""
    if upto == 0:
        return state
    held: dict[int, list[Bracket]] = {}
    for index, bracket in outlined.brackets:
        if upto is not None and index >= upto:
            break
        held.setdefault(index, []).append(bracket)
    if fold.only_brackets:
        for index, brackets in held.items():
            node = LineNode(chunk.line(index), outlined.reading(index), chunk.shapes[index])
            state = fold.marked(state, node, brackets)
        return state
    runs, reading = dict(outlined.runs), outlined.runs[0][1]
    plain = fold.plain
    for index, shape in enumerate(chunk.shapes[:upto]):
        reading = runs.get(index, reading)
        if shape.marked:
            state = fold.marked(state, LineNode(chunk.line(index), reading, shape), held.get(index, ()))
        else:
            state = plain(state, reading, shape)
    return state
