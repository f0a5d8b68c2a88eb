"""What deburr says of a program: findings as values. Never decides whether something is wrong."""

from enum import IntEnum
from typing import NamedTuple


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


class Finding(NamedTuple):
    """One thing that is wrong at one place. ``rule`` is the full name, `rs274.comment-nested`."""

    rule: str
    severity: Severity
    message: str
    place: Place
    related: tuple[Related, ...] = ()

    @property
    def order(self) -> tuple[Place, str, str]:
        """Findings are reported in this order."""
        return (self.place, self.rule, self.message)
