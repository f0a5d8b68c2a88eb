"""Where a Z32 program starts: behind the first `%` line, or at once if there is none (spec/z32.md §1). It has no blocks."""

import re
from collections.abc import Callable, Hashable
from typing import Any

from deburr_grammar.dialect import Reading, Step
from deburr_grammar.line import LineNode

PROGRAM = Reading("program", "line")
TITLE = Reading("title", None)
READINGS = (PROGRAM, TITLE)

_PERCENT = re.compile(r"(?m)^[ \t]*%[ \t]*$")


class Z32Outline:
    """The fold over `%` lines. Text behind M30 stays live: jump targets and sections stand there."""

    marks = r"^[ \t]*%[ \t]*$"
    needs_depth = ""

    def facts(self, text: str) -> frozenset[str]:
        """Whether there is a `%` line: only then is the text before it a title."""
        return frozenset(("percent",)) if _PERCENT.search(text) else frozenset()

    def start(self, facts: frozenset[str]) -> Hashable:
        """Before the first line."""
        return TITLE if "percent" in facts else PROGRAM

    def reading(self, state: Any) -> Reading:
        """The state is the reading."""
        reading: Reading = state
        return reading

    def step(self, state: Any, depth: int, facts: frozenset[str], read: Callable[[Reading], LineNode]) -> Step:
        """A `%` line starts the program; further ones mean nothing."""
        return Step(PROGRAM, (), PROGRAM)
