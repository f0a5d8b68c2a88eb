"""The slow way to all answers that a Document gives: one pass over the lines of the whole text, no chunks, no shapes' trees, nothing kept."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from deburr_grammar.dialect import Bracket, Dialect, Reading, Role
from deburr_grammar.line import LineNode, Shape, shapes_of
from deburr_grammar.problem import Problem
from deburr_grammar.structure import CUTS, StructureFault, reduction
from deburr_grammar.text import Edit, Pos
from deburr_grammar.tree import Node

_END = re.compile(r"\r\n|\r|\n")
_NOTHING = Node("", 0, 0, ())


def lines_of(text: str) -> list[str]:
    """The lines of a text without their endings."""
    return _END.split(text)


def edited(text: str, edit: Edit) -> str:
    """The text after an edit, done on one string."""
    starts, ends = [0], []
    for match in _END.finditer(text):
        ends.append(match.start())
        starts.append(match.end())
    ends.append(len(text))

    def offset(pos: Pos) -> int:
        return len(text) if pos.line >= len(starts) else min(starts[pos.line] + pos.col, ends[pos.line])

    start, end = sorted((offset(edit.start), offset(edit.end)))
    return text[:start] + edit.text + text[end:]


@dataclass(frozen=True)
class NaiveLine:
    """A line as the outline reads it, with its brackets."""

    text: str
    reading: Reading
    shape: str
    brackets: tuple[Bracket, ...]


def outlined(text: str, dialect: Dialect) -> list[NaiveLine]:
    """The outline run over one line after the other."""
    lines, outline, shapes = lines_of(text), dialect.outline, shapes_of(dialect)
    facts = outline.facts("\n".join(lines))
    state, depth = outline.start(facts), 0
    found = []
    for line in lines:
        shape = dialect.folding.fold(line)
        if not dialect.marks.search(shape):
            found.append(NaiveLine(line, outline.reading(state), shape, ()))
            continue
        step = outline.step(state, depth, facts, _reader(line, shapes[shape]))
        found.append(NaiveLine(line, step.reading, shape, tuple(step.brackets)))
        state = step.state
        for bracket in step.brackets:
            depth = (
                0
                if bracket.role in CUTS
                else max(0, depth + (bracket.role is Role.OPEN) - (bracket.role is Role.CLOSE))
            )
    return found


def _reader(line: str, shape: Shape) -> Callable[[Reading], LineNode]:
    return lambda reading: LineNode(line, reading, shape)


@lru_cache(maxsize=65_536)
def read_directly(dialect: Dialect, start: str | None, text: str) -> tuple[Node, tuple[Problem, ...]]:
    """A line's tree and problems by Lark alone, from the line's own text; problems as `told`."""
    if start is None:
        return _NOTHING, ()
    parsed = dialect.grammar.parse(start, text)
    if parsed.deep or sum(map(dialect.folding.fold(text).count, "[(<")) > 200:
        return _NOTHING, (Problem("line-too-deep", 0, len(text)),)
    return parsed.tree, () if parsed.fault is None else told(dialect, text, (dialect.diagnose(parsed.fault),))


def told(dialect: Dialect, line: str, problems: tuple[Problem, ...]) -> tuple[Problem, ...]:
    """The problems of a direct parse as a shape tells them: one that ends inside a digit run or an inert body ends behind it."""
    columns = dialect.folding.columns(line)
    ends = [columns(col) for col in range(len(dialect.folding.fold(line)) + 1)] if problems else []
    return tuple(
        problem._replace(end=next((end for end in ends if problem.end <= end), problem.end)) for problem in problems
    )


def placed(lines: Sequence[NaiveLine]) -> list[tuple[int, Bracket]]:
    """All brackets with their lines."""
    return [(number, bracket) for number, line in enumerate(lines) for bracket in line.brackets]


def balance(brackets: Sequence[tuple[int, Bracket]]) -> tuple[int, int, bool]:
    """Closers before the first cut, openers behind the last, and whether there is a cut."""
    closers = openers = 0
    cut = False
    for _, bracket in brackets:
        if bracket.role in CUTS:
            cut, openers = True, 0
        elif bracket.role is Role.OPEN:
            openers += 1
        elif bracket.role is Role.CLOSE:
            closers += not openers and not cut
            openers = max(0, openers - 1)
    return closers, openers, cut


def faults(brackets: Sequence[tuple[int, Bracket]]) -> tuple[StructureFault, ...]:
    """The faults of the whole in one sweep."""
    return reduction(brackets).all_faults()


def partners(
    brackets: Sequence[tuple[int, Bracket]],
) -> Iterator[tuple[tuple[int, Bracket], tuple[int, Bracket] | None]]:
    """Each opener and closer with its other end, by a stack that every region boundary empties."""
    found: dict[tuple[int, Bracket], tuple[int, Bracket] | None] = {}
    stack: list[tuple[int, Bracket]] = []
    for one in brackets:
        if one[1].role in CUTS:
            stack.clear()
        elif one[1].role is Role.OPEN:
            found[one] = None
            stack.append(one)
        elif one[1].role is Role.CLOSE:
            found[one] = stack.pop() if stack else None
            if (opener := found[one]) is not None:
                found[opener] = one
    return iter(found.items())
