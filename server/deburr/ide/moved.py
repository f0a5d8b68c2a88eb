"""What is known of findings right after an edit, before the whole program has been gone through again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.finding import Finding, Place
from deburr.rule import Long, Modal, Nodes, Syntax, Text
from deburr.ruleset import RuleSet
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


def moved(findings: Iterable[Finding], edits: Sequence[Edit], analysis: Analysis) -> list[Finding]:
    """The findings after the edits: those of touched lines and of structure anew, all others where they stand now."""
    changes = [change_of(edit) for edit in edits]
    touched = touched_lines(changes)
    by_line, structural = _names(analysis.ruleset)
    file = analysis.file
    found = [finding for finding in findings if finding.rule not in structural]
    for change in changes:
        found = [kept for finding in found if (kept := _moved(finding, change, file)) is not None]
    found = [
        each for each in found if not (each.rule in by_line and _on(each.place, touched) and each.place.file == file)
    ]
    for line in touched[:_MOST]:
        if line < analysis.document.line_count:
            found += analysis.line_findings(line)
    for fault in analysis.document.faults if structural else ():
        found += analysis.fault_findings(fault)
    return sorted(set(found), key=lambda finding: finding.order)


def touched_lines(changes: Iterable[Change]) -> list[int]:
    """The lines that the edits changed, as they are numbered behind the last."""
    touched: set[int] = set()
    for change in changes:
        start, end = change.edit.start.line, change.edit.end.line
        kept = {line if line < start else line + change.shift for line in touched if not start <= line <= end}
        touched = kept | set(range(start, start + change.lines + 1)[: _MOST + 1])
    return sorted(touched)


def _on(place: Place, lines: Sequence[int]) -> bool:
    return place.line in lines


def _names(ruleset: RuleSet) -> tuple[frozenset[str], frozenset[str]]:
    """The names of the rules that lines decide, and of those on structure."""
    lines = frozenset(rule.name for rule in ruleset.rules if isinstance(rule.trigger, _BY_LINE))
    return lines, frozenset(rule.name for rule in ruleset.on_structure)


def _moved(finding: Finding, change: Change, file: str) -> Finding | None:
    """A finding behind an edit; None if it stood in what was taken away."""
    place = finding.place
    start, end = change.edit.start, change.edit.end
    if place.file != file or (place.end_line, place.end_col) <= start:
        return finding
    if (place.line, place.col) < end:
        return None
    lines = [_shifted(line, col, change) for line, col in ((place.line, place.col), (place.end_line, place.end_col))]
    return finding._replace(place=Place(place.file, *lines[0], *lines[1]))


def _shifted(line: int, col: int, change: Change) -> tuple[int, int]:
    end = change.edit.end
    if line > end.line:
        return line + change.shift, col
    before = len(change.last) + (0 if change.lines else change.edit.start.col)
    return line + change.shift, col - end.col + before
