"""One line as it should be laid out, and the proof that it still says the same. Never looks at a document."""

from __future__ import annotations

from functools import lru_cache
from typing import TYPE_CHECKING

from deburr.formatting.plan import Change
from deburr_grammar.line import shapes_of
from deburr_grammar.tree import tokens, walk

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from deburr.formatting.plan import Plan
    from deburr_grammar.dialect import Dialect, Reading
    from deburr_grammar.line import Shape
    from deburr_grammar.tree import Token

_TAB = 8


def written(text: str, plan: Plan, lead: str | None, dialect: Dialect) -> str:
    """A line under a plan. ``lead``: the blanks that it is to begin with; None: those that it has."""
    if plan.blank:
        return "" if plan.trimmed else text
    at = len(text) - len(text.lstrip(dialect.blanks))
    out = text[:at] if lead is None or not plan.indented else lead
    for start, end, new in _placed(plan.changes, text, dialect):
        out += text[at:start]
        out += _aside(text, start, end, out) if new is None else new
        at = end
    rest = text[at:]
    return out + (rest.rstrip(dialect.blanks) if plan.trimmed else rest)


def _placed(changes: Sequence[Change], text: str, dialect: Dialect) -> Iterator[Change]:
    """The changes of a shape in columns of a line."""
    to_line = dialect.folding.columns(text) if changes else None
    return (Change(to_line(start), to_line(end), new) for start, end, new in changes if to_line is not None)


def _aside(text: str, start: int, end: int, out: str) -> str:
    """The blanks with which what follows keeps its column, unless what precedes it reaches that far."""
    behind = _width(out)
    return text[start:end] if behind == _width(text[:start]) else " " * max(1, _width(text[:end]) - behind)


def _width(text: str) -> int:
    return len(text.expandtabs(_TAB))


def fits(old: str, new: str, dialect: Dialect) -> bool:
    """Whether the control reads a line of that length, or it is at least no longer than it was."""
    longest = dialect.layout.longest
    return longest is None or _size(new) <= max(longest, _size(old))


def _size(text: str) -> int:
    return len(text.encode("utf-8", "surrogatepass"))


def says_the_same(old: str, shape: Shape, new: str, reading: Reading, plan: Plan) -> bool:
    """Whether a line and its new form have the same tokens: their kinds, the nodes that they stand in, and their texts.

    Blanks at the end of a line are no part of its last token, whatever the grammar says; letters
    may differ in case where the plan says so.
    """
    other = shapes_of(shape.dialect).read(new)[0]
    if shape.marked is not other.marked or not _same_kinds(shape, other, reading):
        return False
    return _texts(_cased(old, plan, shape.dialect), shape, reading) == _texts(new, other, reading)


@lru_cache(maxsize=4_096)
def _same_kinds(shape: Shape, other: Shape, reading: Reading) -> bool:
    """Whether the lines of two shapes are read alike, and without a fault."""
    if other.facts(reading).problems:
        return False
    return [part.kind for part in walk(shape.tree(reading))] == [part.kind for part in walk(other.tree(reading))]


@lru_cache(maxsize=4_096)
def _tokens(shape: Shape, reading: Reading) -> tuple[Token, ...]:
    return tuple(tokens(shape.tree(reading)))


def _texts(text: str, shape: Shape, reading: Reading) -> list[str]:
    """The texts of a line's tokens."""
    to_line = shape.dialect.folding.columns(text)
    found = [text[to_line(start) : to_line(end)] for _, start, end in _tokens(shape, reading)]
    if found:
        found[-1] = found[-1].rstrip(shape.dialect.blanks)
    return found


def _cased(text: str, plan: Plan, dialect: Dialect) -> str:
    """The line with letters in their new case, and all blanks as they were."""
    letters = [change for change in plan.changes if change.text is not None and change.text.strip()]
    for start, end, new in _placed(letters, text, dialect):
        text = f"{text[:start]}{new}{text[end:]}"
    return text
