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
        """Findings are reported in this order; two that have all of it in common are one, however one comes there."""
        return (self.place, self.rule, self.message)


_ALSO = "also "


def joined(one: Finding, other: Finding) -> Finding:
    """What two programs find at one place of a file that both use, as one finding: how the first of them comes there, and from where else one does.

    Where the file alone is wrong, who else uses it is no matter. In whichever order several are joined, the same comes out.
    """
    if one == other:
        return one
    severity, fix = max(one.severity, other.severity), one.fix or other.fix
    alone = [each for each in (one, other) if not any(related.entered for related in each.related)]
    if len(alone) == 1:
        return alone[0]._replace(severity=severity, fix=fix)
    parts = [_parted(each) for each in (one, other)]
    (way, _), (behind, _) = sorted(parts, key=lambda part: [(each.place, each.message) for each in reversed(part[0])])
    others = {each for _, also in parts for each in also}
    others |= {Related(each.place, f"{_ALSO}{each.message}") for each in behind if each not in way}
    others -= {Related(each.place, f"{_ALSO}{each.message}") for each in way}
    return one._replace(severity=severity, related=(*way, *sorted(others)), fix=fix)


def _parted(finding: Finding) -> tuple[tuple[Related, ...], tuple[Related, ...]]:
    """How one comes to a finding, and from where else."""
    way = tuple(each for each in finding.related if each.entered or not each.message.startswith(_ALSO))
    return way, tuple(each for each in finding.related if each not in way)
