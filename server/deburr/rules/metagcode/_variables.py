"""The configured values of variables, as the rules of one program see them. Never judges a use of one."""

import posixpath
import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.formats.variables import Value, Values, read_values
from deburr.host import NoFiles
from deburr.includes import beside
from deburr.rule import Note
from deburr.rules.metagcode._gathered import Gathered, gathered
from deburr_grammar.chunk import Chunk
from deburr_grammar.dialects.metagcode.forms import names
from deburr_grammar.text import Span


class Configured(NamedTuple):
    """The file with the values of a program. ``read``: what is in it; None if it cannot be read."""

    path: str
    read: Values | None

    @property
    def name(self) -> str:
        """The file's name without its folder."""
        return posixpath.basename(self.path)

    @property
    def known(self) -> Mapping[str, Value]:
        """The values by their names."""
        return self.read.known if self.read is not None else {}

    def given(self, define: Mapping[str, str]) -> Mapping[str, str]:
        """The values by their names, those that are given by name before those of the file."""
        named = {name.strip(" \t"): text for name, text in define.items()}
        return {name: value.text for name, value in self.known.items()} | named


class Bad(NamedTuple):
    """A value that none may be: its name, its text, its file's name, the first place that refers to it or else the first line, and where it is defined."""

    name: str
    value: str
    file: str
    line: int
    span: Span
    note: Note


def configured(analysis: Analysis) -> Configured | None:
    """The configured values; None if there are none, or if the program is a snippet, which says nothing by itself."""
    if __name__ not in analysis.memo:
        analysis.memo[__name__] = _configured(analysis)
    found: Configured | None = analysis.memo[__name__]
    return found


def bad_values(analysis: Analysis, pattern: re.Pattern[str]) -> Iterator[Bad]:
    """The values that hold what no value may."""
    found = configured(analysis)
    if found is None:
        return
    for name, value in found.known.items():
        if pattern.search(value.text):
            note = Note(value.line, value.span, f"`{name}` is defined here", found.path)
            yield Bad(name, value.text, found.name, *_first_use(analysis, name), note)


def first_line(analysis: Analysis) -> Span:
    """The columns of the first line, for what has no place of its own in the program."""
    return Span(0, max(len(analysis.document.line(0)), 1))


def names_of(chunk: Chunk) -> Mapping[str, list[int]]:
    """The names in a chunk with the lines in which they stand: kept with the chunk."""
    found: dict[str, list[int]] | None = chunk.memo.get(__name__)
    if found is None:
        found = chunk.memo[__name__] = {}
        for index in range(len(chunk.shapes)) if "|" in chunk.text else ():
            for _, name in names(chunk.line(index)):
                found.setdefault(name, []).append(index)
    return found


def _configured(analysis: Analysis) -> Configured | None:
    setting = str(analysis.settings["variables"])
    if not setting or isinstance(analysis.host, NoFiles) or gathered(analysis).library.inside:
        return None
    path = beside(analysis.file, setting)
    text = analysis.host.read(path)
    return Configured(path, None if text is None else read_values(text, path))


def _first_use(analysis: Analysis, name: str) -> tuple[int, Span]:
    for piece in analysis.document.pieces():
        for index in names_of(piece.chunk).get(name, ())[:1]:
            text = piece.chunk.line(index)
            start = next(at for at, each in names(text) if each == name)
            return piece.line + index, Span(start, text.index("|", start + 1) + 1)
    blocks = gathered(analysis)
    return next(_brought(blocks, name), (0, first_line(analysis)))


def _brought(blocks: Gathered, name: str) -> Iterator[tuple[int, Span]]:
    """The `#FILE` lines whose snippets refer to a name."""
    for line, bracket in blocks.files:
        effect = blocks.effects[line]
        if effect is not None and name in effect.names:
            yield line, bracket.span
