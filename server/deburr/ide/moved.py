"""What is known of findings right after an edit, before the whole program has been gone through again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from operator import is_
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.finding import Finding, Place, Related
from deburr.ide.held import Held
from deburr.rule import Long, Modal, Nodes, Syntax, Text
from deburr.ruleset import RuleSet
from deburr.suppress import allows_anything, is_allowed
from deburr_grammar.structure import StructureFault
from deburr_grammar.text import Edit, split_lines

_BY_LINE = Syntax | Nodes | Modal | Text | Long
_MOST = 50
"""Touched lines that are looked at at once; a paste of more waits for the whole."""


class Change(NamedTuple):
    """An edit in lines: from which line to which it took away, both included, and how many line ends it put there."""

    edit: Edit
    lines: int
    last: str

    @property
    def shift(self) -> int:
        """How many lines further down the rest now stands."""
        return self.lines - (self.edit.end.line - self.edit.start.line)


def change_of(edit: Edit) -> Change:
    """An edit with what moves by it."""
    lines = split_lines(edit.text)
    return Change(edit, len(lines) - 1, lines[-1])


def moved(held: Held, edits: Sequence[Edit], analysis: Analysis) -> Held:
    """Findings after the edits, each where it stands now, but for those that the touched lines decide: `found_anew` has these."""
    changes = [change_of(edit) for edit in edits]
    for change in changes:
        start, end = change.edit.start.line, change.edit.end.line
        held = held.changed(start, end, change.shift, partial(_moved, change=change))
    return held.without(touched_lines(changes), _by_line(analysis.ruleset))


def found_anew(edits: Sequence[Edit], analysis: Analysis) -> list[Finding]:
    """What the touched lines decide by themselves."""
    touched = touched_lines([change_of(edit) for edit in edits])
    there = (line for line in touched[:_MOST] if line < analysis.document.line_count)
    return [finding for line in there for finding in analysis.line_findings(line)]


class Structure(NamedTuple):
    """What findings of block structure hang on: its faults, the rules, and whether a comment may allow any."""

    faults: tuple[StructureFault, ...] = ()
    ruleset: RuleSet | None = None
    allowing: bool = True

    def stays(self, other: Structure) -> bool:
        """Whether the findings of one are those of the other. No fault is looked at: those of a program that only says something else are the same object."""
        same = self.faults is other.faults and self.ruleset is other.ruleset
        return same and not self.allowing and not other.allowing


def structure_of(analysis: Analysis) -> Structure:
    """What the findings of its blocks hang on."""
    faults = analysis.document.faults if analysis.ruleset.on_structure else ()
    return Structure(faults, analysis.ruleset, allows_anything(analysis.document))


def structural(analysis: Analysis, structure: Structure) -> list[Finding]:
    """What the structure of the blocks decides."""
    found = [finding for fault in structure.faults for finding in analysis.fault_findings(fault)]
    return [each for each in found if not is_allowed(analysis.document, each)] if structure.allowing else found


def touched_lines(changes: Iterable[Change]) -> list[int]:
    """The lines that the edits changed, as they are numbered behind the last."""
    touched: set[int] = set()
    for change in changes:
        start, end = change.edit.start.line, change.edit.end.line
        kept = {line if line < start else line + change.shift for line in touched if not start <= line <= end}
        touched = kept | set(range(start, start + change.lines + 1)[: _MOST + 1])
    return sorted(touched)


def _by_line(ruleset: RuleSet) -> frozenset[str]:
    """The names of the rules that lines decide."""
    return frozenset(rule.name for rule in ruleset.rules if isinstance(rule.trigger, _BY_LINE))


def _moved(finding: Finding, change: Change) -> Finding | None:
    """A finding behind an edit of its file: the same one if neither it nor what it points to stands on a line of the edit or moves; None if it was taken away."""
    file = finding.place.file
    place = _place(finding.place, change)
    if place is None:
        return None
    related = tuple(_related(each, change) if each.place.file == file else each for each in finding.related)
    if place is finding.place and all(map(is_, related, finding.related)):
        return finding
    return finding._replace(place=place, related=related)


def _related(related: Related, change: Change) -> Related:
    """What a finding points at; where the edit took that away, the edit."""
    start = change.edit.start
    place = _place(related.place, change) or Place(related.place.file, start.line, start.col, start.line, start.col)
    return related if place is related.place else related._replace(place=place)


def _place(place: Place, change: Change) -> Place | None:
    start, end = change.edit.start, change.edit.end
    if (place.end_line, place.end_col) <= start:
        return place
    if (place.line, place.col) < end:
        return None
    if place.line > end.line and not change.shift:
        return place
    # On the last line of the edit it is another one even where its columns are the same: of units in front of it there may be others.
    ends = [_shifted(line, col, change) for line, col in ((place.line, place.col), (place.end_line, place.end_col))]
    return Place(place.file, *ends[0], *ends[1])


def _shifted(line: int, col: int, change: Change) -> tuple[int, int]:
    end = change.edit.end
    if line > end.line:
        return line + change.shift, col
    before = len(change.last) + (0 if change.lines else change.edit.start.col)
    return line + change.shift, col - end.col + before
