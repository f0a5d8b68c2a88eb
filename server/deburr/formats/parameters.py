"""Stored parameters of an RS274 control (`.var`): a number and a value a line. Never opens a file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from deburr.formats import Fault
from deburr_grammar.text import Span, split_lines

LAST = 5601
"""Parameters go from 1 to this (spec/rs274.md §4.1)."""


class Parameters(NamedTuple):
    """The values by their numbers, and what is wrong with the file."""

    values: dict[int, float]
    faults: tuple[Fault, ...]


def read(text: str) -> Parameters:
    """The parameters of a file's text."""
    values, faults = dict[int, float](), list[Fault]()
    for row, line in enumerate(split_lines(text)):
        if not line.strip():
            continue
        pair = _pair(line.split())
        if pair is not None:
            values[pair[0]] = pair[1]
        else:
            message = f"`{line.strip()[:40]}` is no stored parameter: write its number, 1 to {LAST}, and its value"
            faults.append(Fault(row, Span(0, len(line)), message))
    return Parameters(values, tuple(faults))


def faults(text: str) -> Iterator[Fault]:
    """What is wrong with a file."""
    yield from read(text).faults


def _pair(words: list[str]) -> tuple[int, float] | None:
    if len(words) != 2 or not (words[0].isascii() and words[0].isdigit() and 1 <= int(words[0]) <= LAST):
        return None
    try:
        return int(words[0]), float(words[1])
    except ValueError:
        return None
