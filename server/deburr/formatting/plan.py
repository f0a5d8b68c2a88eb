"""What is to be done with all lines of a shape: gaps between tokens and cases of letters. Decided once a shape, never looks at a document."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.layout import Between, Case, Gap
from deburr_grammar.tree import Node, Token, tokens, walk

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.layout import Layout
    from deburr_grammar.line import Shape


class Change(NamedTuple):
    """What stands in a stretch of a shape instead. None: so many blanks that what follows keeps its column."""

    start: int
    end: int
    text: str | None


class Plan(NamedTuple):
    """Changes from left to right, and what becomes of the blanks around a line. ``blank``: the line holds nothing else."""

    changes: tuple[Change, ...]
    indented: bool
    trimmed: bool
    blank: bool


def plan_of(shape: Shape, reading: Reading, canonical: bool) -> Plan | None:
    """The plan for a shape; None where its lines are not to be touched: they are not read, or not without a fault."""
    key = ("plan", reading.name, canonical)
    if key not in shape.memo:
        shape.memo[key] = _made(shape, reading, canonical)
    found = shape.memo[key]
    assert found is None or isinstance(found, Plan)
    return found


def _made(shape: Shape, reading: Reading, canonical: bool) -> Plan | None:
    facts = shape.facts(reading)
    if reading.start is None or facts.problems:
        return None
    layout, tree, blank = shape.dialect.layout, shape.tree(reading), not shape.text.strip(shape.dialect.blanks)
    changes = [*_gaps((tree,), shape.text, layout), *(_cases(tree, shape.text, layout) if canonical else ())]
    trimmed = layout.empties if blank else not layout.trimmed.isdisjoint(facts.kinds)
    return Plan(tuple(sorted(changes)), not layout.indented.isdisjoint(facts.kinds), trimmed, blank)


def _gaps(around: tuple[Node, ...], text: str, layout: Layout, spaced: bool | None = None) -> Iterator[Change]:
    """The changes between the tokens of a node and below. ``spaced``: whether the chain of operators that it is part of has blanks."""
    chosen = [(between, layout.gap(between)) for between in _betweens(around, text)]
    chained = any(gap is Gap.EVEN for _, gap in chosen)
    if chained and spaced is None:
        spaced = any(_blanks(between) for part in _chain(around) for between in _evens(part, text, layout))
    for between, gap in chosen:
        old = _blanks(between)
        new = _written(gap, old, bool(spaced))
        if new != old:
            yield Change(between.left.end, between.right.start, new)
    for child in around[-1].nodes():
        same = chained and child.kind == around[-1].kind
        yield from _gaps((*around, child), text, layout, spaced if same else None)


def _written(gap: Gap, old: str, spaced: bool) -> str | None:
    match gap:
        case Gap.KEEP:
            return old
        case Gap.NONE:
            return ""
        case Gap.ONE:
            return " "
        case Gap.SOME:
            return old or " "
        case Gap.FEW:
            return " " if old else ""
        case Gap.EVEN:
            return " " if spaced else ""
        case Gap.ASIDE:
            return " " if old in ("", " ") else None


def _betweens(around: tuple[Node, ...], text: str) -> Iterator[Between]:
    """The places between the parts of a node."""
    parts = [said for child in around[-1].children if (said := list(tokens(child)))]
    return (Between(text, around, left[-1], right[0]) for left, right in pairwise(parts))


def _chain(around: tuple[Node, ...]) -> Iterator[tuple[Node, ...]]:
    """A node and those of its kind that are its parts: `1+2+3` is two sums."""
    yield around
    for child in around[-1].nodes():
        if child.kind == around[-1].kind:
            yield from _chain((*around, child))


def _evens(around: tuple[Node, ...], text: str, layout: Layout) -> Iterator[Between]:
    return (between for between in _betweens(around, text) if layout.gap(between) is Gap.EVEN)


def _blanks(between: Between) -> str:
    return between.text[between.left.end : between.right.start]


def _cases(tree: Node, text: str, layout: Layout) -> Iterator[Change]:
    for node in (part for part in walk(tree) if isinstance(part, Node)):
        for token in node.children:
            if isinstance(token, Token) and (case := layout.case(node, token)) is not Case.ANY:
                old = text[token.start : token.end]
                new = old.upper() if case is Case.UPPER else old.lower()
                if new != old:
                    yield Change(token.start, token.end, new)
