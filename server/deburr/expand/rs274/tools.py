"""Tool tables: `T1 P1 Z25.4 D6.35 ;name` a line. Never decides which tool is in the spindle."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from deburr.expand.job import Job

_WORD = re.compile(r"([A-Z])\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))", re.I)
_OFFSETS = "XYZABCUVW"


class Tool:
    """A tool as the table has it, in the machine's own unit."""

    def __init__(self, number: int, words: dict[str, float] | None = None) -> None:
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
    found = {0: Tool(0)}
    for line in (job.host.read(path) or "").split("\n") if path else ():
        words = {letter.upper(): float(value) for letter, value in _WORD.findall(line.partition(";")[0])}
        if "T" in words:
            found[round(words["T"])] = Tool(round(words["T"]), words)
    return found
