"""What stands behind a fault: the rest of a faulty line, read as if the fault were blanks. For showing names only; never says what is right."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.line import LineNode, Shape, shapes_of

if TYPE_CHECKING:
    from deburr_grammar.dialect import Dialect, Reading

_MOST = 8
"""So many faults of a line are passed by."""


class _Blank(NamedTuple):
    """A stretch of a shape that is taken for blanks."""

    start: int
    end: int


def rests(line: LineNode) -> Iterator[LineNode]:
    """The line behind its first fault, behind the one that stands there, and so on; nothing of a line without one."""
    shape, reading = line.shape, line.reading
    if reading.start is None or not shape.readable or not shape.facts(reading).problems:
        return
    key = ("rests", reading.name)
    blanks = shape.memo.get(key)
    if not isinstance(blanks, tuple):
        blanks = shape.memo[key] = tuple(_blanks(shape, reading))
    to_line, text = line.dialect.folding.columns(line.text), line.text
    for blank in blanks:
        text = _blanked(text, to_line(blank.start), to_line(blank.end))
        yield LineNode(text, reading, _shape(line.dialect, text))


def _blanks(shape: Shape, reading: Reading) -> Iterator[_Blank]:
    """Of each fault the stretch behind which reading comes farthest: the fault, all before it, or all up to its end."""
    since = 0
    for _ in range(_MOST):
        problem = next(iter(shape.facts(reading).problems), None)
        if problem is None:
            return
        since, end = max(since, problem.start), max(problem.end, problem.start + 1)
        tried = [(_read(shape, start, stop), start, stop) for start, stop in ((since, end), (0, since), (0, end))]
        reached = [_reach(each, reading) for each, _, _ in tried]
        best = reached.index(max(reached))
        shape, start, stop = tried[best]
        if not shape.text.strip():
            return
        yield _Blank(start, stop)
        since = end


def _read(shape: Shape, start: int, end: int) -> Shape:
    return _shape(shape.dialect, _blanked(shape.text, start, end))


def _reach(shape: Shape, reading: Reading) -> int:
    """The column up to which a shape can be read."""
    return min((each.start for each in shape.facts(reading).problems), default=len(shape.text) + 1)


def _blanked(text: str, start: int, end: int) -> str:
    return text[:start] + " " * (min(end, len(text)) - start) + text[end:]


def _shape(dialect: Dialect, text: str) -> Shape:
    return shapes_of(dialect)[dialect.folding.fold(text)]
