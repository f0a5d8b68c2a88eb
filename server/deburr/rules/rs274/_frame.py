"""How a program is framed: its percent signs, its end, and what may be one. What is found in a chunk is kept with it."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.rules.rs274._files import Target, World, world_of
from deburr.rules.rs274._program import program_of
from deburr_grammar.dialect import Reading
from deburr_grammar.dialects.rs274.outline import State, codes
from deburr_grammar.document import Piece
from deburr_grammar.line import LineNode, Shape
from deburr_grammar.text import Span
from deburr_grammar.tree import Token

_ENDING = frozenset(("M2", "M30", "M98", "M99"))
"""M99 ends a program that nothing called, and what M98 calls may do so."""
_PIECE = "(not_a_subfile)"


class Text(NamedTuple):
    """A line's number and the columns of its text without the blanks around it."""

    line: int
    span: Span


def first_line(analysis: Analysis) -> Text | None:
    """The first line that is not blank; None: there is none."""
    pieces = (piece for piece in analysis.document.pieces() if piece.chunk.text.strip())
    return next((text for piece in pieces for text in _texts(piece, range(piece.lines))), None)


def last_line(analysis: Analysis) -> Text | None:
    """The last line that is not blank."""
    pieces = (piece for piece in reversed(tuple(analysis.document.pieces())) if piece.chunk.text.strip())
    return next((text for piece in pieces for text in _texts(piece, range(piece.lines - 1, -1, -1))), None)


def _texts(piece: Piece, indices: Sequence[int]) -> Iterator[Text]:
    for index in indices:
        text = piece.chunk.line(index)
        if text.strip():
            yield Text(piece.line + index, Span(len(text) - len(text.lstrip()), len(text.rstrip())))


def percents(analysis: Analysis) -> list[tuple[int, LineNode]]:
    """The lines with a percent sign that the control reads, in order; also those that it cannot read because of one."""
    return list(_lines(analysis, "percents", _has_percent, lambda text: "%" in text))


def starts_with_percent(analysis: Analysis) -> bool:
    """Whether the first thing in the program is a percent sign: then it may end with another one."""
    first = first_line(analysis)
    return first is not None and "PERCENT" in analysis.document.node(first.line).kinds


def ends(analysis: Analysis) -> bool:
    """Whether it is certain that the program comes to an end: M2 or M30 outside all blocks, or a second percent sign."""
    state = None
    for piece in analysis.document.pieces():
        state = piece.outlined.state
    assert isinstance(state, State)
    return state.ended or state.closed


def may_end(analysis: Analysis) -> bool:
    """Whether the program may come to an end on some way through it or in another file.

    In a program whose blocks are at fault, M2 may stand where nobody meant it to stand.
    """
    main = program_of(analysis)
    called = {call.label for call in main.calls}
    if not called <= set(main.by_label) and _ends_elsewhere(world_of(analysis)):
        return True
    sure = not analysis.document.faults
    for at, _ in _lines(analysis, "ends", _is_end, lambda text: "m" in text or "M" in text):
        inside = main.sub_at(at) if sure else None
        if inside is None or inside.label in called:
            return True
    return False


def _ends_elsewhere(world: World) -> bool:
    """Whether a called file may end the program."""
    return not world.is_complete or any(_may_end(target) for target in world.reached.values())


def _may_end(target: Target) -> bool:
    assert target.program is not None and target.sub is not None
    document = target.program.document
    last = min(target.sub.end, document.line_count - 1)
    return any(_is_end(document.node(at)) for at in range(target.sub.start, int(last) + 1))


def is_part(analysis: Analysis) -> bool:
    """Whether the file is not meant to be started: it defines subprograms and does nothing outside them, or is a piece for ngcgui."""
    if any(_PIECE in piece.chunk.text for piece in analysis.document.pieces()):
        return True
    main = program_of(analysis)
    return bool(main.subs) and not main.has_main


def _lines(
    analysis: Analysis, name: str, wanted: Callable[[LineNode], bool], may: Callable[[str], bool]
) -> Iterator[tuple[int, LineNode]]:
    """The lines that are read and wanted, in order. Both questions must hang on the shape alone; ``may`` is the quick one, asked of whole chunks too."""
    for piece in analysis.document.pieces():
        key = (f"rs274 {name}", analysis.document.key(piece))
        if key not in piece.chunk.memo:
            piece.chunk.memo[key] = tuple(_indices(piece, wanted, may)) if may(piece.chunk.text) else ()
        yield from ((piece.line + index, piece.node(index)) for index in piece.chunk.memo[key])


def _indices(piece: Piece, wanted: Callable[[LineNode], bool], may: Callable[[str], bool]) -> Iterator[int]:
    def says(reading: Reading, shape: Shape) -> bool:
        return reading.start is not None and may(shape.text) and wanted(LineNode(shape.text, reading, shape))

    return (index for index, _, _ in piece.where(says))


def _has_percent(line: LineNode) -> bool:
    return "PERCENT" in line.kinds or any(problem.kind == "percent" for problem in line.problems)


def _is_end(line: LineNode) -> bool:
    """Whether a line ends the program or may do so: of a computed M code only the run knows which one it is."""
    if any(code in _ENDING for code, _ in codes(line)):
        return True
    words = (word for word in line.find("word") if line.text[word.start] in "mM")
    return any(not isinstance(word.children[1], Token) for word in words)
