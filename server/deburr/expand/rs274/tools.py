"""Tool tables: `T1 P1 Z25.4 D6.35 ;name` a line. Never decides which tool is in the spindle."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from deburr.formats.tools import read

if TYPE_CHECKING:
    from deburr.expand.job import Job

_OFFSETS = "XYZABCUVW"


class Tool:
    """A tool as the table has it, in the machine's own unit."""

    def __init__(self, number: int, words: Mapping[str, float] | None = None) -> None:
        self.number = number
        self._words = words or {}

    @property
    def offsets(self) -> list[float]:
        """Its offsets along the axes."""
        return [self._words.get(axis, 0.0) for axis in _OFFSETS]

    def value(self, at: int) -> float:
        """What #5400 and those behind it hold: number, nine offsets, diameter, front and back angle, orientation."""
        return [float(self.number), *self.offsets, *(self._words.get(letter, 0.0) for letter in "DIJQ")][at]


def read_tools(job: Job) -> dict[int, Tool]:
    """The tools of the configured table by number; 0 is no tool."""
    path = job.settings["tool-table"]
    words = read((job.host.read(path) or "") if path else "").words
    return {0: Tool(0), **{number: Tool(number, said) for number, said in words.items()}}
