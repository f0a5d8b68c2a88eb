"""Files that are no programs but are read with one: toolpaths, machine files. Readers take text and give values; faults are values too."""

from typing import NamedTuple

from deburr_grammar.text import Span


class Fault(NamedTuple):
    """What is wrong with such a file. ``ignored``: the rest can be used as if it did not stand there."""

    line: int
    span: Span
    message: str
    ignored: bool = False
