"""What rules on the whole program share: lines by what stands in them, block numbers, jumps, sections. Kept with each chunk."""

from bisect import bisect_left, bisect_right
from collections.abc import Generator, Iterator, Mapping, Sequence
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import integer
from deburr.expand.z32.unit import ACTIVE
from deburr.includes import z32 as stores
from deburr.rule import Line
from deburr.rules.z32._fields import goes_on
from deburr.rules.z32._values import known
from deburr.steps import done, kept, paced
from deburr_grammar.dialects.z32.forms import NUMBERED, number, number_of
from deburr_grammar.document import Piece
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_KEPT = frozenset(
    ("jump", "call", "file_call", "section", "config", "other", "alias_name", "axis_alias", "nword", "M_END", "G26")
)


_BY_NUMBER = "z32 blocks by number"


class Label(NamedTuple):
    """A block number: its line and its columns."""

    line: int
    span: Span


class Jump(NamedTuple):
    """A GON: where it stands, where it goes, and where it returns from. None: only the run knows, or there is none."""

    line: int
    node: Node
    target: float | None
    target_span: Span
    end: float | None
    end_span: Span | None
    certain: bool
    """Whether its line jumps on every run."""


def lines(analysis: Analysis, *kinds: str) -> Iterator[tuple[int, LineNode]]:
    """The lines that hold one of some kinds of parts, in order. Only kinds that are kept can be asked for."""
    return ((piece.line + index, piece.node(index)) for piece, index in _places(analysis, kinds))


def _places(analysis: Analysis, kinds: Sequence[str]) -> Iterator[tuple[Piece, int]]:
    for piece in analysis.document.pieces():
        held = _held(analysis, piece)
        for index in sorted(set().union(*(held.get(kind, ()) for kind in kinds))):
            yield piece, index


def numbers_of(analysis: Analysis, *kinds: str) -> Sequence[int]:
    """The numbers of the lines that hold one of some kinds of parts; kept with the analysis."""
    key = ("z32 numbers", kinds)
    if key not in analysis.memo:
        analysis.memo[key] = [piece.line + index for piece, index in _places(analysis, kinds)]
    found: Sequence[int] = analysis.memo[key]
    return found


def within(numbers: Sequence[int], first: int, before: int) -> Sequence[int]:
    """The numbers from ``first`` to before ``before``, of some in order."""
    return numbers[bisect_left(numbers, first) : bisect_left(numbers, before)]


def first_block(analysis: Analysis) -> int | None:
    """The first line that does anything."""
    for piece in analysis.document.pieces():
        for index in _held(analysis, piece).get("block", ()):
            return piece.line + index
    return None


def _held(analysis: Analysis, piece: Piece) -> Mapping[str, list[int]]:
    """The indices of a chunk's lines by the kinds of parts in them; of blocks only the first."""
    key = ("z32 lines", analysis.document.key(piece))
    found: dict[str, list[int]] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = {}
        for reading, first, shapes in piece.read():
            kinds = {shape: shape.facts(reading).kinds for shape in set(shapes)}
            wanted = {shape: found_kinds & _KEPT for shape, found_kinds in kinds.items()}
            for index, shape in enumerate(shapes, first):
                for kind in wanted[shape]:
                    found.setdefault(kind, []).append(index)
                if "block" not in found and not ACTIVE.isdisjoint(kinds[shape]):
                    found["block"] = [index]
    return found


def labels(analysis: Analysis, value: float) -> list[Label]:
    """The blocks of that number."""
    # Asked for each jump: what is known already is not to be found in steps.
    found: Mapping[float, list[Label]] | None = analysis.memo.get(_BY_NUMBER)
    return (done(_labelling(analysis)) if found is None else found).get(value, [])


def _labelling(analysis: Analysis) -> Generator[None, None, Mapping[float, list[Label]]]:
    return kept(analysis.memo, _BY_NUMBER, lambda: _by_number(analysis))


def _by_number(analysis: Analysis) -> Generator[None, None, Mapping[float, list[Label]]]:
    found: dict[float, list[Label]] = {}
    for each in paced(all_labels(analysis)):
        if each is None:
            yield
        else:
            found.setdefault(each[0], []).append(each[1])
    return found


def all_labels(analysis: Analysis) -> Iterator[tuple[float, Label]]:
    """All block numbers."""
    for piece in analysis.document.pieces():
        for value, places in _labels(analysis, piece).items():
            yield from ((value, Label(piece.line + index, _span(piece, index))) for index in places)


def _span(piece: Piece, index: int) -> Span:
    match = NUMBERED.match(piece.chunk.line(index))
    assert match is not None
    return Span(*match.span(1))


def _labels(analysis: Analysis, piece: Piece) -> Mapping[float, list[int]]:
    """The indices of a chunk's lines by their block numbers."""
    key = ("z32 labels", analysis.document.key(piece))
    found: dict[float, list[int]] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = {}
        for index in _held(analysis, piece).get("nword", ()):
            if match := NUMBERED.match(piece.chunk.line(index)):
                found.setdefault(number(match[2]), []).append(index)
    return found


def jumps(analysis: Analysis) -> tuple[Jump, ...]:
    """All GON instructions."""
    return done(_jumping(analysis))


def ready_jumps(analysis: Analysis) -> Iterator[None]:
    """Find the GON instructions and what they lead to, in steps."""
    yield from _jumping(analysis)
    yield from _labelling(analysis)


def _jumping(analysis: Analysis) -> Generator[None, None, tuple[Jump, ...]]:
    return kept(analysis.memo, "z32 jumps", lambda: _all_jumps(analysis))


def _all_jumps(analysis: Analysis) -> Generator[None, None, tuple[Jump, ...]]:
    found: list[Jump] = []
    for placed in paced(lines(analysis, "jump")):
        if placed is None:
            yield
            continue
        line = Line(placed[1], analysis.settings)
        certain = is_certain(line.node)
        found += [_jump(placed[0], line, jump, certain) for jump in line.node.find("jump")]
    return tuple(found)


def is_certain(node: LineNode) -> bool:
    """Whether a line with a jump jumps on every run."""
    return "DELETE" not in node.kinds and not any(goes_on(advanced) for advanced in node.find("advanced"))


def _jump(at: int, line: Line, jump: Node, certain: bool) -> Jump:
    end = jump.node("range_end")
    target = jump.children[1]
    span = Span(end.start + 1, end.end) if end else None
    ended = known(line, end.children[1]) if end else None
    return Jump(at, jump, known(line, target), Span(target.start, target.end), ended, span, certain)


def entries(analysis: Analysis) -> set[float] | None:
    """The block numbers that jumps lead to; None where one is computed, so that it may lead anywhere."""
    targets = [jump.target for jump in jumps(analysis)]
    return None if None in targets else {target for target in targets if target is not None}


def sections(analysis: Analysis) -> list[int]:
    """The lines that start a section."""
    return list(numbers_of(analysis, "section"))


def section_of(starts: list[int], line: int) -> int:
    """The number of the section that a line stands in; 0: before the first."""
    return bisect_right(starts, line)


def is_main(analysis: Analysis) -> bool:
    """Whether it is certain that the operator starts this program: its main part ends in M2 or M30, and not at a jump target.

    A subprogram may hold an M30 too, but behind a condition, not as its last block.
    """
    if stores.is_stored(analysis.file, analysis.settings):
        return False
    starts = sections(analysis)
    last = last_block(analysis, 0, starts[0] if starts else analysis.document.line_count)
    if last is None or "M_END" not in analysis.document.node(last).kinds:
        return False
    reached, value = entries(analysis), number_of(analysis.document.line(last))
    return value is None or (reached is not None and value not in reached)


def last_block(analysis: Analysis, first: int, before: int) -> int | None:
    """The last line that does anything, of those from ``first`` to before ``before``."""
    numbers = range(before - 1, first - 1, -1)
    return next((at for at in numbers if not ACTIVE.isdisjoint(analysis.document.node(at).kinds)), None)


def called(line: Line, call: Node) -> int | None:
    """The number of the program that a GOP or GOS calls; None where only the run knows it or it is no integer."""
    value = known(line, call.children[1])
    return integer(value) if value is not None else None


def beside(analysis: Analysis, path: str) -> str:
    """A configured path as the host knows it: relative ones start at the program's folder."""
    return stores.beside(analysis.file, path)


def is_active(analysis: Analysis, line: int) -> bool:
    """Whether a line does anything: words or an advanced line."""
    return not ACTIVE.isdisjoint(analysis.document.node(line).kinds)


def first_line(analysis: Analysis) -> int | None:
    """The first line of the program that is not blank: behind the `%` if there is one."""
    for at in range(analysis.document.line_count):
        node = analysis.document.node(at)
        if node.reading.start is not None and "PERCENT" not in node.kinds and node.text.strip():
            return at
    return None
