"""One line of a program taken apart: its settings, words and comments, and how it is written flat (spec/rs274.md §4.3, §5, §7). Knows no flow."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from copy import copy
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand.numbers import written
from deburr.expand.rs274.comments import Comment
from deburr.expand.rs274.source import Source, Spot
from deburr.expand.rs274.values import Get, Numbers, Put, Values
from deburr_grammar.codes import code_number
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

if TYPE_CHECKING:
    from deburr.expand.rs274.state import State
    from deburr_grammar.line import LineNode

ACTS = -1
"""The piece of a flat line that is the comment that acts."""
Piece = str | int
_BLANKS = re.compile(r"[ \t]*")
_INDENT = re.compile(r"[ \t]*\Z")


class Word(NamedTuple):
    """A word: its letter, what calculates its value, whether that is literal, its code if it is a G or M word of which that is known, and its value in the tree."""

    letter: str
    get: Get
    literal: bool
    code: str
    part: Node | Token


class Line:
    """What a line without flow holds."""

    def __init__(self, state: State, source: Source, node: LineNode, numbers: Numbers | None = None) -> None:
        """``node``: the line itself, or the sample of its shape, in columns of which the source is then asked."""
        self.node = node
        self.source = source
        self._keep_n = state.job.inputs.keep_n
        self.values = Values(state, source, numbers)
        self.words: list[Word] = []
        self.settings: list[tuple[Callable[[], Put], Get]] = []
        self.comment: Comment | None = None
        """The comment that acts: the last one."""
        self._parts: list[tuple[Node | Token, int]] = []
        for part in _parts(node.tree):
            self._take(part)
        acting = [part for part, _ in self._parts if part.kind in ("COMMENT", "active")]
        self._acting = acting[-1] if acting else None
        if self._acting is not None:
            self.comment = Comment(state, Spot(source, self._acting))

    def _take(self, part: Node | Token) -> None:
        number = -1
        if isinstance(part, Node) and part.kind == "setting":
            param = part.children[0]
            assert isinstance(param, Node)
            self.settings.append((self.values.setter(param), self.values.value(part.children[2])))
        elif isinstance(part, Node) and part.kind == "word":
            number = len(self.words)
            self.words.append(self._word(part))
        self._parts.append((part, number))

    def _word(self, part: Node) -> Word:
        letter, value = self.node.text[part.start].upper(), part.children[1]
        code = code_number(self.values.said(part)) if letter in "GM" and isinstance(value, Token) else ""
        return Word(letter, self.values.value(value), _is_literal(value), code, value)

    @cached_property
    def deleted(self) -> bool:
        """Whether the line begins with `/`."""
        return self.node.tree.find("DELETE") is not None

    def begins_with(self, code: str) -> bool:
        """Whether nothing stands before this code."""
        _, number = self._parts[0]
        return number == 0 and self.words[0].code == code

    @cached_property
    def computed(self) -> tuple[int, ...]:
        """The numbers of M words of which only the run knows the code."""
        return tuple(at for at, word in enumerate(self.words) if word.letter == "M" and not word.code)

    def with_codes(self, said: Sequence[int]) -> Line:
        """The same line once its computed M words have come to these codes."""
        line = copy(self)
        codes = dict(zip(self.computed, said))
        line.words = [
            word._replace(code=f"M{codes[at]}") if at in codes else word for at, word in enumerate(self.words)
        ]
        return line

    def codes(self) -> frozenset[str]:
        """The G and M codes that are known."""
        return frozenset(word.code for word in self.words if word.code)

    def pieces(self, leave_out: frozenset[str] = frozenset(), computed: str = "") -> list[Piece]:
        """The flat line: text, numbers of words whose values are to be written, and `ACTS`. Empty if nothing is left.

        ``leave_out``: codes, and letters, of words that are not written.
        ``computed``: letters of words whose values are written anew though they are literal.
        """
        text = self.node.text
        found = self.stretches(leave_out, computed)
        return _joined([text[piece.start : piece.end] if isinstance(piece, Span) else piece for piece in found])

    def stretches(self, leave_out: frozenset[str] = frozenset(), computed: str = "") -> list[Span | int]:
        """The same with columns in place of text."""
        at = self._start(False)
        head = Span(self._start(self._keep_n), at)
        found: list[Span | int] = []
        for part, number in self._parts:
            found.append(Span(at, part.start))
            at = part.end
            word = self.words[number] if number >= 0 else None
            left_out = word is not None and (word.code in leave_out or word.letter in leave_out)
            if part.kind == "setting" or left_out:
                at = _behind_blanks(self.node.text, at)
            elif word is not None and (not word.literal or word.letter in computed):
                found += [Span(part.start, part.start + 1), number]
            else:
                found.append(ACTS if part is self._acting else Span(part.start, at))
        found.append(Span(at, len(self.node.text)))
        # A line number alone is no line.
        blank = all(isinstance(piece, Span) and not self.node.text[piece.start : piece.end].strip() for piece in found)
        return [] if blank else [head, *found]

    def _start(self, keep_n: bool) -> int:
        """Where the flat line begins: behind block delete and line number."""
        heads = [
            part
            for part in self.node.tree.children
            if part.kind == "DELETE" or (part.kind == "line_number" and not keep_n)
        ]
        return _behind_blanks(self.node.text, heads[-1].end) if heads else 0


def text_of(pieces: list[Piece], values: list[float], comment: Comment | None, decimals: int, minus_zero: bool) -> str:
    """A flat line from its pieces and the values of its words."""
    found = []
    for piece in pieces:
        if isinstance(piece, str):
            found.append(piece)
        elif piece == ACTS:
            found.append(comment.flat() if comment is not None else "")
        else:
            found.append(written(values[piece], decimals, minus_zero))
    return "".join(found)


def _parts(tree: Node) -> Iterator[Node | Token]:
    """The items of a line in order."""
    for child in tree.children:
        if isinstance(child, Node) and child.kind == "item":
            yield child.children[0]
        elif child.kind == "SEMICOLON_COMMENT":
            yield child


def _joined(pieces: list[Piece]) -> list[Piece]:
    """Neighbouring text as one piece."""
    joined: list[Piece] = []
    for piece in pieces:
        if isinstance(piece, str) and joined and isinstance(joined[-1], str):
            joined[-1] += piece
        elif piece != "":
            joined.append(piece)
    return joined


def _is_literal(value: Node | Token) -> bool:
    while isinstance(value, Node) and value.kind == "signed":
        value = value.children[1]
    return isinstance(value, Token)


def _behind_blanks(text: str, at: int) -> int:
    match = _BLANKS.match(text, at)
    return match.end() if match is not None else at
