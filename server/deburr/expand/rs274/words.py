"""Literal words of a line by its shape: which letters, and which of its numbers are their values. Calculates nothing."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.rs274 import number
from deburr_grammar.codes import code_number
from deburr_grammar.dialects.rs274.outline import PROGRAM
from deburr_grammar.tree import Node, Token, walk

if TYPE_CHECKING:
    from deburr_grammar.line import Shape

_DIGITS = r"[0-9](?:[ \t]*[0-9])*"
NUMBERS = re.compile(rf"{_DIGITS}(?:[ \t]*\.(?:[ \t]*[0-9])*)?|\.[ \t]*{_DIGITS}")
"""What can be a number; lines of one shape have as many, in the same places, up to the first comment."""
COMMENT = re.compile(r"[(;]")
"""Where the first comment of a line starts."""


class Word(NamedTuple):
    """A literal word: its letter, which number of the line is its value, and its sign."""

    letter: str
    number: int
    sign: float


def words_of(shape: Shape) -> tuple[Word, ...] | None:
    """The words of a line whose values are all literal; None if a comment stands before one of them."""
    key = "rs274 words"
    if key not in shape.memo:
        shape.memo[key] = _read(shape)
    found = shape.memo[key]
    assert found is None or isinstance(found, tuple)
    return found


def values(text: str, words: tuple[Word, ...]) -> list[float]:
    """The values of such words on a line."""
    found = NUMBERS.findall(text)
    return [number(found[word.number]) * word.sign for word in words]


def codes_of(shape: Shape) -> frozenset[str]:
    """The literal G and M codes of lines of a shape: their numbers are part of it."""
    text = shape.text
    return frozenset(
        code_number(text[part.start : part.end])
        for part in walk(shape.tree(PROGRAM))
        if isinstance(part, Node)
        and part.kind == "word"
        and text[part.start] in "GMgm"
        and isinstance(part.children[1], Token)
    )


def starts(text: str) -> dict[int, int]:
    """Which number of a line starts in which column, up to the first comment."""
    comment = COMMENT.search(text)
    end = comment.start() if comment is not None else len(text)
    return {match.start(): at for at, match in enumerate(NUMBERS.finditer(text, 0, end))}


def _read(shape: Shape) -> tuple[Word, ...] | None:
    places, found = starts(shape.text), []
    for part in walk(shape.tree(PROGRAM)):
        if isinstance(part, Node) and part.kind == "word":
            value, sign = part.children[1], 1.0
            while isinstance(value, Node) and value.kind == "signed":
                sign = -sign if shape.text[value.start] == "-" else sign
                value = value.children[1]
            if value.start not in places:
                return None
            found.append(Word(shape.text[part.start].upper(), places[value.start], sign))
    return tuple(found)
