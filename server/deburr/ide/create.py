"""Files that a program names and that are not there: where they would lie, and the least that they must hold."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.ide.definition import file_of
from deburr.ide.refactor import moves_of
from deburr.symbols.index import at

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr.ide.refactor import NewFile
    from deburr.ide.view import View


def missing_file(view: View, finding: Finding) -> NewFile | None:
    """The file whose absence is what a finding says; None if that is not what it says."""
    moves, place = moves_of(view.dialect.name), finding.place
    placed = at(view.document, place.line, place.col) if place.file == view.file else None
    if moves is None or placed is None or finding.rule.partition(".")[2] not in moves.MISSING:
        return None
    found = moves.missing(view, placed)
    there = found is None or file_of(view, placed.mention.symbol) or view.host.read(found.file) is not None
    return None if there else found
