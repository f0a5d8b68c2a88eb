"""Tool tables of an RS274 control: `T1 P1 Z25.4 D6.35 ;name` a line. Never opens a file."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from deburr.formats import Fault
from deburr_grammar.text import Span, split_lines

_WORD = r"([TPDXYZABCUVWIJQ])\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))"
_LINE = rf"\s*(?:{_WORD}\s*)+"


class Tools(NamedTuple):
    """The words of each tool by its number, and what is wrong with the file."""

    words: dict[int, Mapping[str, float]]
    faults: tuple[Fault, ...]


def read(text: str) -> Tools:
    """The tools of a table's text."""
    found, faults = dict[int, Mapping[str, float]](), list[Fault]()
    for row, line in enumerate(split_lines(text)):
        said = line.partition(";")[0]
        if not said.strip():
            continue
        words = {letter.upper(): float(value) for letter, value in re.findall(_WORD, said, re.I)}
        if re.fullmatch(_LINE, said, re.I) and "T" in words:
            found[round(words["T"])] = words
        else:
            message = f"`{said.strip()[:40]}` is no tool: write `T1 P1 Z25.4 D6.35 ;name`"
            faults.append(Fault(row, Span(0, len(said)), message))
    return Tools(found, tuple(faults))


def faults(text: str) -> Iterator[Fault]:
    """What is wrong with a table."""
    yield from read(text).faults
