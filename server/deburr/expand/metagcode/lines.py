"""The lines of a MetaGCODE text as steps of a run: each is read once and kept (spec/metagcode.md §5.3 to §5.5). Never looks for files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.metagcode import COMPARISONS
from deburr_grammar.dialects.metagcode.forms import condition, groups, is_numeric, name, number
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Token

if TYPE_CHECKING:
    from decimal import Decimal

    from deburr_grammar.chunk import Chunk
    from deburr_grammar.dialect import Bracket
    from deburr_grammar.document import Document

_KEPT = 100_000
"""Lines that a file keeps ready because they are run again."""

Filled = str | tuple[str, ...]
"""A line without references, or its pieces: text and names in turn."""


class Item(NamedTuple):
    """A value on a directive line: its text or the name of its variable, the number that the text is, and its columns."""

    said: str
    is_name: bool
    number: Decimal | None
    span: Span


class Condition(NamedTuple):
    """What an `#IF` asks."""

    left: Item
    holds: Callable[[object, object], bool]
    right: Item
    numeric: bool


class Counter(NamedTuple):
    """A variable of a `#LOOP` with its maxStep."""

    total: Item
    step: Item
    relative: bool


class Text:
    """One file: its path, its document, and where its lines are cut out of it."""

    def __init__(self, file: str, document: Document) -> None:
        self.file = file
        self.document = document
        self.rows = document.rows
        self.room = _KEPT
        self._cut: tuple[Chunk | None, list[str]] = (None, [])

    def lines(self, first: int, stop: int) -> Iterator[Sequence[str]]:
        """A stretch of lines in pieces."""
        while first < stop:
            piece = self.document.piece(first)
            if self._cut[0] is not piece.chunk:
                self._cut = (piece.chunk, piece.chunk.lines)
            behind = piece.line + piece.chunk.eols
            end = stop if behind <= first else min(stop, behind)
            yield self._cut[1][first - piece.line : end - piece.line]
            first = end


class Stretch:
    """Neighbouring lines without a directive."""

    __slots__ = ("_kept", "_runs", "first", "stop", "text")

    def __init__(self, text: Text, first: int, stop: int) -> None:
        self.text = text
        self.first = first
        self.stop = stop
        self._runs = 0
        self._kept: list[Filled] | None = None

    @property
    def lines(self) -> Iterable[Filled]:
        """The lines; those that are asked for again are kept."""
        if self._kept is not None:
            return self._kept
        self._runs += 1
        size = self.stop - self.first
        if self._runs == 1 or size > self.text.room:
            return self._read()
        self.text.room -= size
        self._kept = list(self._read())
        return self._kept

    def _read(self) -> Iterator[Filled]:
        for lines in self.text.lines(self.first, self.stop):
            for line in lines:
                yield _filled(line) if "|" in line else line


class Directive:
    """An `#IF`, a `#LOOP` or the end of one."""

    __slots__ = ("_condition", "_counters", "bracket", "row", "text")

    def __init__(self, text: Text, row: int, bracket: Bracket) -> None:
        self.text = text
        self.row = row
        self.bracket = bracket
        self._condition: Condition | None = None
        self._counters: tuple[Counter, ...] = ()

    @property
    def said(self) -> str:
        """The directive as it should be written: `#LOOP1`."""
        return self.bracket.word + (self.bracket.label or "")

    @property
    def condition(self) -> Condition:
        """What a faultless `#IF` asks."""
        if self._condition is None:
            self._condition = _condition(self.text.document.node(self.row))
        return self._condition

    @property
    def counters(self) -> tuple[Counter, ...]:
        """The variables of a faultless `#LOOP`."""
        if not self._counters:
            self._counters = _counters(self.text.document.node(self.row))
        return self._counters


def _filled(line: str) -> tuple[str, ...]:
    pieces = line.split("|")
    pieces[1::2] = [each.strip(" \t") for each in pieces[1::2]]
    return tuple(pieces)


@lru_cache(maxsize=4096)
def _condition(line: LineNode) -> Condition:
    left, operator, right, type_ = condition(next(line.find("condition")))
    holds = COMPARISONS[line.text[operator.start : operator.end].lower()]
    return Condition(_item(line, left), holds, _item(line, right), is_numeric(line.text[type_.start : type_.end]))


@lru_cache(maxsize=4096)
def _counters(line: LineNode) -> tuple[Counter, ...]:
    return tuple(
        Counter(_item(line, group.counter), _item(line, group.step), line.text[group.mode.start] in "rR")
        for group in groups(next(line.find("header")))
    )


def _item(line: LineNode, token: Token) -> Item:
    said = line.text[token.start : token.end]
    is_name = token.kind == "VARIABLE"
    return Item(name(said) if is_name else said, is_name, None if is_name else number(said), Span(*token[1:]))
