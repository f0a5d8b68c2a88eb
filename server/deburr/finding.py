"""What deburr says of a program: findings as values. Never decides whether something is wrong."""

from enum import IntEnum
from typing import NamedTuple

from deburr_grammar.text import Edit


class Severity(IntEnum):
    """How much a finding matters. An error: the control would stop, or the expansion would be wrong."""

    INFO = 1
    WARNING = 2
    ERROR = 3

    @property
    def word(self) -> str:
        """The severity as it is written in configuration and reports."""
        return self.name.lower()


class Place(NamedTuple):
    """A stretch of a file: 0-based lines and 0-based columns in code points, the end excluded."""

    file: str
    line: int
    col: int
    end_line: int
    end_col: int


class Related(NamedTuple):
    """Another place that explains a finding: the other end of a pair, a link of a chain."""

    place: Place
    message: str
    entered: bool = False
    """Whether a run was in it, as in a call or a pass of a loop; these come innermost first."""


class Fix(NamedTuple):
    """What would be done: its title, its edits of the program, none of which touches another, and whether it is safe."""

    title: str
    edits: tuple[Edit, ...]
    safe: bool = False

    @property
    def applicability(self) -> str:
        """How sure it is, as reports have it."""
        return "safe" if self.safe else "unsafe"


class Finding(NamedTuple):
    """One thing that is wrong at one place. ``rule`` is the full name, `rs274.comment-nested`."""

    rule: str
    severity: Severity
    message: str
    place: Place
    related: tuple[Related, ...] = ()
    fix: Fix | None = None
    """What would mend it; only where somebody asked for it (deburr/fix.py)."""

    @property
    def order(self) -> tuple[Place, str, str]:
        """Findings are reported in this order."""
        return (self.place, self.rule, self.message)
