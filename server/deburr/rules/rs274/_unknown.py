"""Codes that no table names: where they stand, and how much that weighs. Kept with each chunk."""

from collections.abc import Iterator
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.rule import Line, Severity
from deburr.rules.rs274._files import world_of
from deburr.rules.rs274._words import entry, words
from deburr_grammar.dialect import Reading
from deburr_grammar.document import Piece
from deburr_grammar.line import LineNode, Shape


class Unknown(NamedTuple):
    """A code: its line, its word's number there, how it is spelled, and the severity of saying so."""

    at: int
    line: Line
    word: int
    code: str
    severity: Severity


def unknown(analysis: Analysis, letter: str) -> Iterator[Unknown]:
    """The codes of a letter that no table names.

    A file of subprograms alone is part of a machine's configuration, and such a file's machine may
    have codes of its own (REMAP). There it is but a warning.
    """
    for piece in analysis.document.pieces():
        for index in _lines(analysis, piece):
            line = Line(piece.node(index), analysis.settings)
            for word, code in enumerate(words(line).codes):
                if code.startswith(letter) and not entry(line, code):
                    severity = Severity.WARNING if world_of(analysis).is_library else Severity.ERROR
                    yield Unknown(piece.line + index, line, word, code, severity)


def _lines(analysis: Analysis, piece: Piece) -> tuple[int, ...]:
    key = ("rs274 unknown codes", analysis.document.key(piece))
    found: tuple[int, ...] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = tuple(_of_piece(analysis, piece))
    return found


def _of_piece(analysis: Analysis, piece: Piece) -> Iterator[int]:
    return (index for index, _, _ in piece.where(lambda reading, shape: _has_unknown(analysis, reading, shape)))


def _has_unknown(analysis: Analysis, reading: Reading, shape: Shape) -> bool:
    if reading.start is None or "word" not in shape.facts(reading).kinds:
        return False
    key = ("rs274 unknown codes", reading.name)
    if key not in shape.memo:
        line = Line(LineNode(shape.text, reading, shape), analysis.settings)
        shape.memo[key] = any(code and not entry(line, code) for code in words(line).codes)
    return bool(shape.memo[key])
