"""Lines as a part of their own that is called in their place: a subprogram, a snippet, a section. Refuses where that would mean something else, and by proof."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.fix import applied
from deburr.ide.proof import proving
from deburr.ide.refactor import Cannot, Work, moves_of
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from collections.abc import Iterable

    from deburr.ide.refactor import NewFile
    from deburr.ide.view import View

LONGEST = 5_000
"""Lines that are looked at as a selection."""


class Extracted(NamedTuple):
    """The edits of the program, and the file that it then needs."""

    edits: tuple[Edit, ...]
    file: NewFile | None


def selected(start: Pos, end: Pos) -> tuple[int, int]:
    """The lines of a selection, the last included: one that ends before a line's first sign does not hold that line."""
    return start.line, end.line - 1 if end.col == 0 and end.line > start.line else end.line


def could_extract(view: View, start: Pos, end: Pos) -> str:
    """What the selected lines could become; nothing: "". Looks at no line."""
    moves = moves_of(view.dialect.name)
    first, last = selected(start, end)
    return moves.EXTRACTED if moves is not None and start < end and last - first < LONGEST else ""


def extracted(view: View, start: Pos, end: Pos) -> Work[Extracted]:
    """The selected lines as a part of their own; Cannot where that would mean something else."""
    moves = moves_of(view.dialect.name)
    first, last = selected(start, end)
    last = min(last, view.document.line_count - 1)
    if moves is None or not any(view.document.line(at).strip() for at in range(first, last + 1)):
        raise Cannot("there is nothing in these lines")
    found = moves.extracted(view, first, last)
    ends = Pos(last, len(view.document.line(last)))
    edits = [Edit(Pos(first, 0), ends, found.call)]
    if found.lines:
        edits.insert(0, _inserted(view, found.line, found.lines))
    files = {} if found.file is None else {found.file.file: found.file.text}
    yield from proving(view, applied(view.document, edits), files)
    return Extracted(tuple(edits), found.file)


def _inserted(view: View, line: int, lines: Iterable[str]) -> Edit:
    """Whole lines before a line, or at the end."""
    text = "".join(f"{each}\n" for each in lines)
    end = view.document.line_count - 1
    if line <= end:
        return Edit(Pos(line, 0), Pos(line, 0), text)
    at = Pos(end, len(view.document.line(end)))
    return Edit(at, at, f"\n{text}" if at.col else text)
