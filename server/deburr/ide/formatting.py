"""Layout as an editor asks for it: of a program, of some of its lines, of what has just been typed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from deburr.formatting.line import written
from deburr.formatting.plan import plan_of
from deburr.formatting.program import formatted, proven, standing
from deburr.formatting.switches import Switches

if TYPE_CHECKING:
    from deburr.formatting.program import Stand
    from deburr.formatting.style import Style
    from deburr.ide.view import View
    from deburr_grammar.text import Edit, Pos

Lines = tuple[int, int]
"""The first and the last line of a stretch."""


def formatting(view: View, style: Style, wanted: Sequence[Lines] | None = None) -> Iterator[list[Edit]]:
    """The edits that lay out a program, or the stretches that are wanted of it; in parts, so that the work can be left between."""
    done = -1
    for first, last in sorted(wanted) if wanted is not None else [(0, view.document.line_count - 1)]:
        yield from formatted(view.document, style, max(first, done + 1), last)
        done = max(done, last)


def typed(view: View, style: Style, pos: Pos, char: str) -> list[Edit]:
    """The edits that indent what was typed: behind a line end the line that it ends and the one that it starts, otherwise the word of a block that is whole now."""
    stand = _stand(view, pos.line)
    if char == "\n":
        above = [_stand(view, pos.line - 1)] if pos.line else []
        return [edit for each in (*above, stand) for edit in _indented(view, style, each, each is stand)]
    brackets = stand.stepped.step.brackets if stand.stepped is not None else ()
    ended = any(each.span.end == pos.col for each in brackets)
    return list(_indented(view, style, stand, False)) if ended else []


def _stand(view: View, line: int) -> Stand:
    return next(stand for stand in standing(view.document, view.document.piece(line)) if stand.line == line)


def _indented(view: View, style: Style, stand: Stand, writes: bool) -> Iterator[Edit]:
    """The edit that indents a line and does nothing else. ``writes``: the next word is written there, so blanks alone are not taken away."""
    plan = plan_of(stand.shape, stand.reading, False)
    if plan is None or Switches(view.document).off(stand.line):
        return
    lead = style.indent * stand.level
    if plan.blank and writes:
        new = lead if plan.indented else stand.text
    else:
        new = written(stand.text, plan._replace(changes=(), trimmed=plan.blank and plan.trimmed), lead, view.dialect)
    yield from proven(view.document, stand, plan, new)
