"""Codes that no table names: where they stand, and how much that weighs. Kept with each chunk."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.rule import Line, Severity
from deburr.rules.rs274._files import world_of
from deburr.rules.rs274._words import entry, node, remap, words
from deburr_grammar.dialect import Reading
from deburr_grammar.document import Piece
from deburr_grammar.line import LineNode, Shape

CALLS = "M98"
"""The control knows it only at the beginning of a line (spec/rs274.md §6)."""
_HEAD = re.compile(r"[ \t]*/?[ \t]*(?:[nN][ \t]*[0-9][0-9 \t]*(?:\.[0-9 \t]*)?)?")


class Unknown(NamedTuple):
    """A code: its line, its word's number there, how it is spelled, and the severity of saying so."""

    at: int
    line: Line
    word: int
    code: str
    severity: Severity


def unknown(analysis: Analysis, letter: str) -> Iterator[Unknown | None]:
    """The codes of a letter that no table names, with a None behind each chunk.

    A file of subprograms alone is part of a machine's configuration, and such a file's machine may
    have codes of its own (REMAP). There it is but a warning.
    """
    for piece in analysis.document.pieces():
        for index in _lines(analysis, piece):
            line = Line(piece.node(index), analysis.settings)
            for word, code in enumerate(words(line).codes):
                if code.startswith(letter) and _is_unknown(line, code, word):
                    severity = Severity.WARNING if world_of(analysis).is_library else Severity.ERROR
                    yield Unknown(piece.line + index, line, word, code, severity)
        yield None


def _lines(analysis: Analysis, piece: Piece) -> tuple[int, ...]:
    key = ("rs274 unknown codes", analysis.document.key(piece), analysis.settings["remap"])
    found: tuple[int, ...] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = tuple(_of_piece(analysis, piece))
    return found


def _of_piece(analysis: Analysis, piece: Piece) -> Iterator[int]:
    return (index for index, _, _ in piece.where(lambda reading, shape: _has_unknown(analysis, reading, shape)))


def _has_unknown(analysis: Analysis, reading: Reading, shape: Shape) -> bool:
    if reading.start is None or "word" not in shape.facts(reading).kinds:
        return False
    key = ("rs274 unknown codes", reading.name, analysis.settings["remap"])
    if key not in shape.memo:
        line = Line(LineNode(shape.text, reading, shape), analysis.settings)
        shape.memo[key] = any(code and _is_unknown(line, code, word) for word, code in enumerate(words(line).codes))
    return bool(shape.memo[key])


def _is_unknown(line: Line, code: str, word: int) -> bool:
    if code == CALLS:
        return not comes_first(line, word)
    return not entry(line, code) and code not in remap(line.settings["remap"])


def comes_first(line: Line, word: int) -> bool:
    """Whether nothing but a line number stands before a word."""
    return _HEAD.fullmatch(line.text, 0, node(line, word).start) is not None
