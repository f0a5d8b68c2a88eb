"""Positions in text, and the three line endings. Never looks at what a line means."""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator
from itertools import accumulate
from typing import NamedTuple

EOL = re.compile(r"\r\n|\n|\r")
_AND_ITS_END = (1).__add__


class Pos(NamedTuple):
    """A place in a document: 0-based line, 0-based column in code points."""

    line: int
    col: int


class Span(NamedTuple):
    """A stretch of one line: 0-based columns in code points, the end excluded."""

    start: int
    end: int


class Edit(NamedTuple):
    """Replace what stands between two positions by a text. Positions past a line's or the document's end mean its end."""

    start: Pos
    end: Pos
    text: str


def line_starts(text: str) -> array[int]:
    """Offsets at which lines start; one more than there are line ends, so the last entry starts the tail."""
    if "\r" in text:
        return array("I", (0, *(match.end() for match in EOL.finditer(text))))
    starts = array("I", accumulate(map(_AND_ITS_END, map(len, text.split("\n"))), initial=0))
    starts.pop()
    return starts


def with_newlines(text: str) -> str:
    """The text with every line ending written as one newline."""
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def split_lines(text: str) -> list[str]:
    """The lines of a text without their endings; at least one, perhaps empty."""
    return with_newlines(text).split("\n")


def cut_points(text: str, size: int) -> Iterator[int]:
    """Offsets, each just behind a line end, that cut a text into pieces of about ``size`` characters."""
    carriage = "\r" in text
    at = size
    while at < len(text):
        if carriage:
            # One step back, so that the search cannot start between `\r` and `\n` and take the newline for an ending of its own.
            match = EOL.search(text, at - 1)
            at = match.end() if match else len(text)
        else:
            at = text.find("\n", at) + 1 or len(text)
        if at < len(text):
            yield at
            at += size
