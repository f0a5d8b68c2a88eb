"""Files that are no programs but are read with one: toolpaths, machine files. Readers take text and give values; faults are values too."""

from collections.abc import Iterator
from importlib import import_module
from typing import NamedTuple

from deburr_grammar.text import Span


class Fault(NamedTuple):
    """What is wrong with such a file. ``ignored``: the rest can be used as if it did not stand there."""

    line: int
    span: Span
    message: str
    ignored: bool = False


_OF_SETTINGS = {"parameters": "parameters", "tool-table": "tools"}
"""The modules that read what settings name."""


def faults(setting: str, text: str) -> Iterator[Fault]:
    """What is wrong with a file that a setting names, where a run would read it without a word."""
    if setting in _OF_SETTINGS:
        yield from import_module(f"{__name__}.{_OF_SETTINGS[setting]}").faults(text)
