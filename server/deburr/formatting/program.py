"""A program laid out: edits line by line, each proven to leave the tokens of its line and the structure of the program as they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.formatting.line import fits, says_the_same, written
from deburr.formatting.plan import plan_of
from deburr.formatting.switches import Switches
from deburr_grammar.dialect import Role
from deburr_grammar.line import shapes_of
from deburr_grammar.structure import CUTS
from deburr_grammar.text import Edit, Pos, line_starts

if TYPE_CHECKING:
    from deburr.formatting.plan import Plan
    from deburr.formatting.style import Style
    from deburr_grammar.dialect import Bracket, Reading
    from deburr_grammar.dialect import Step as Done
    from deburr_grammar.document import Document, Piece
    from deburr_grammar.layout import Layout
    from deburr_grammar.line import Shape
    from deburr_grammar.outline import Before, Stepped


_SLICE = 100
"""So many lines are laid out at a time."""


class Stand(NamedTuple):
    """A line where it stands: its number, how it is read, how many levels deep, and what it does if it is marked."""

    line: int
    text: str
    shape: Shape
    reading: Reading
    level: int
    stepped: Stepped | None


def formatted(document: Document, style: Style, first: int = 0, last: int | None = None) -> Iterator[list[Edit]]:
    """The edits that lay out the lines from one to another, both included; a list for some lines each, so that the work can be left between.

    In a program whose blocks do not pair nobody knows how deep its lines stand: indentation is left as it is.
    """
    switches, indents = Switches(document), not document.faults
    last = document.line_count - 1 if last is None else min(last, document.line_count - 1)
    found: list[Edit] = []
    while first <= last:
        piece = document.piece(first)
        for stand in standing(document, piece):
            if first <= stand.line <= last and not switches.off(stand.line):
                lead = style.indent * stand.level if indents else None
                found += laid_out(document, stand, lead, style)
            if stand.line % _SLICE == 0:
                yield found
                found = []
        first = max(first, piece.line + piece.lines - 1) + 1
    yield found


def standing(document: Document, piece: Piece) -> Iterator[Stand]:
    """The lines of a piece where they stand, the empty one behind its last line end among them."""
    layout, chunk = document.dialect.layout, piece.chunk
    marked = {stepped.number: stepped for stepped in document.steps(piece)}
    runs, reading = dict(piece.outlined.runs), piece.outlined.runs[0][1]
    inside = _deep(piece.before, layout)
    for number, (text, shape) in enumerate(zip(chunk.lines, [*chunk.shapes, chunk.table[""]])):
        reading = runs.get(number, reading)
        stepped = marked.get(number)
        level = inside if stepped is None else _level(stepped, layout)
        yield Stand(piece.line + number, text, shape, reading, level, stepped)
        if stepped is not None:
            inside = _deep(stepped.after, layout)


def laid_out(document: Document, stand: Stand, lead: str | None, style: Style) -> Iterator[Edit]:
    """What lays out a line. ``lead``: the blanks that it is to begin with, if it may be indented; None: those that it has."""
    plan = plan_of(stand.shape, stand.reading, style.canonical)
    if plan is not None:
        yield from proven(document, stand, plan, written(stand.text, plan, lead, document.dialect))


def proven(document: Document, stand: Stand, plan: Plan, new: str) -> Iterator[Edit]:
    """The smallest edit that gives a line its new form; none where that is not proven to say and do the same as the one it has."""
    old = stand.text
    if new == old or not fits(old, new, document.dialect) or (not new and _parts(document, stand.line)):
        return
    if not says_the_same(old, stand.shape, new, stand.reading, plan) or not _does_the_same(document, stand, new):
        return
    shorter = min(len(old), len(new))
    start = next((at for at in range(shorter) if old[at] != new[at]), shorter)
    end = next((at for at in range(shorter - start) if old[-1 - at] != new[-1 - at]), shorter - start)
    yield Edit(Pos(stand.line, start), Pos(stand.line, len(old) - end), new[start : len(new) - end])


def applied(text: str, edits: Iterable[Edit]) -> str:
    """A text after edits, each within a line, in order."""
    starts, pieces, done = line_starts(text), list[str](), 0
    for edit in edits:
        start, end = starts[edit.start.line] + edit.start.col, starts[edit.end.line] + edit.end.col
        pieces += text[done:start], edit.text
        done = end
    return "".join((*pieces, text[done:]))


def _does_the_same(document: Document, stand: Stand, new: str) -> bool:
    """Whether the new form of a line leaves the program's readings, brackets and facts as they are."""
    outline = document.dialect.outline
    if outline.facts(stand.text) != outline.facts(new):
        return False
    if stand.stepped is None:
        return True
    shape = shapes_of(document.dialect).read(new)[0]
    return _outcome(document.step(stand.stepped.before, shape, new)) == _outcome(stand.stepped.step)


def _parts(document: Document, line: int) -> bool:
    """Whether all that parts two line ends stands on a line: without it `\\r` and `\\n` would be one."""
    return line > 0 and _ending(document, line - 1) == "\r" and _ending(document, line) == "\n"


def _ending(document: Document, line: int) -> str:
    piece = document.piece(line)
    return piece.chunk.ending(line - piece.line)


def _outcome(step: Done) -> tuple[object, ...]:
    """What a step comes to, wherever its brackets stand in the line."""
    return step.reading, step.state, [(each.role, each.kind, each.word, each.label) for each in step.brackets]


def _deep(before: Before, layout: Layout) -> int:
    return before.balance.openers + layout.inside(before.state)


def _level(stepped: Stepped, layout: Layout) -> int:
    """How deep a marked line stands: as deep as the opener that it closes or parts."""
    deep = _deep(stepped.before, layout)
    first: Bracket | None = next(iter(stepped.step.brackets), None)
    if first is None:
        return deep
    if first.role in CUTS:
        return 0
    parts = first.role is Role.CLOSE or (first.role is Role.MIDDLE and first.kind in layout.parted)
    return max(0, deep - 1) if parts else deep
