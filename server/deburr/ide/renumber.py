"""Other numbers for all lines or all blocks of a program, in order. All that goes to a number goes with it; refuses where a number is computed or known elsewhere, and by proof."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.fix import applied
from deburr.ide.proof import proving
from deburr.ide.refactor import Cannot, Work, moves_of
from deburr.ide.related import uses
from deburr.symbols import Act, Sort
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.ide.refactor import Moves, Numbering
    from deburr.ide.view import View
    from deburr.symbols import Mention, Symbol
    from deburr_grammar.dialect import Bracket

_LOCAL = (Sort.LABEL,)
_STEP = 100
"""Lines that are gone through in one step."""


class _Number(NamedTuple):
    """A number in the program: where it stands, what it names, in which section."""

    line: int
    span: Span
    symbol: Symbol
    act: Act
    section: int


def renumbered_lines(view: View) -> Work[tuple[Edit, ...]]:
    """The edits that give the lines that have a number new ones, and jumps their new targets; Cannot where that cannot be done."""
    moves = _moves(view)
    if moves.LINES is None:
        raise Cannot("lines have no numbers that this program uses")
    found = yield from _line_numbers(view, moves)
    defined = [each for each in found if each.act is Act.DEFINE]
    _refuse(found, defined)
    numbers = _sequence(moves.LINES, len(defined))
    targets = {(each.section, each.symbol.name): number for each, number in zip(defined, numbers)}
    edits = [_edit(each, number) for each, number in zip(defined, numbers)]
    edits += [_edit(each, targets[each.section, each.symbol.name]) for each in found if each.act is Act.CALL]
    return (yield from _proven(view, edits))


def renumbered_blocks(view: View) -> Work[tuple[Edit, ...]]:
    """The edits that give blocks and numbered subprograms new numbers, in the order of the program; the same number stays the same."""
    moves = _moves(view)
    if moves.BLOCKS is None:
        raise Cannot("blocks have no numbers")
    found = yield from _block_numbers(view, moves)
    if any(not each.symbol.name for each in found):
        raise Cannot("a number is computed, or called in a way that cannot be followed")
    kept = _kept(view, found)
    order = [name for name in dict.fromkeys(each.symbol.name for each in found) if name not in kept]
    numbers = _sequence(moves.BLOCKS, len(order), {int(name) for name in kept})
    table = dict(zip(order, numbers))
    return (
        yield from _proven(view, [_edit(each, table[each.symbol.name]) for each in found if each.symbol.name in table])
    )


def _moves(view: View) -> Moves:
    moves = moves_of(view.dialect.name)
    if moves is None:
        raise Cannot("nothing is numbered in this language")
    return moves


def _line_numbers(view: View, moves: Moves) -> Work[list[_Number]]:
    found: list[_Number] = []
    section = -1
    for line, node in enumerate(view.document.nodes()):
        if moves.starts_section(node):
            section = line
        found += [_number(line, each, section) for each in moves.line_numbers(node)]
        if line % _STEP == 0:
            yield
    return found


def _block_numbers(view: View, moves: Moves) -> Work[list[_Number]]:
    found: list[_Number] = []
    for line, node in enumerate(view.document.nodes()):
        found += [_number(line, each, 0) for each in moves.block_numbers(node)]
        if line % _STEP == 0:
            yield
    return found


def _number(line: int, mention: Mention, section: int) -> _Number:
    return _Number(line, mention.inner, mention.symbol, mention.act, section)


def _refuse(found: list[_Number], defined: list[_Number]) -> None:
    """Cannot, where it cannot be seen to which line a jump goes."""
    times: dict[tuple[int, str], int] = {}
    for each in defined:
        times[each.section, each.symbol.name] = times.get((each.section, each.symbol.name), 0) + 1
    for each in found:
        if each.act is not Act.CALL:
            continue
        if not each.symbol.name:
            raise Cannot(f"the jump in line {each.line + 1} goes to a number that is computed")
        count = times.get((each.section, each.symbol.name), 0)
        if count != 1:
            what = "is not there" if count == 0 else "is there more than once"
            raise Cannot(f"the target N{each.symbol.name} of the jump in line {each.line + 1} {what}")


def _kept(view: View, found: list[_Number]) -> set[str]:
    """Numbers of subprograms in other files; Cannot if other files call those of this one."""
    defined = {each.symbol for each in found if each.act is Act.DEFINE and each.symbol.sort not in _LOCAL}
    for symbol in defined:
        if other := next((each.file for each, _ in uses(view, symbol, None) if each.file != view.file), ""):
            raise Cannot(f"`{symbol.name}` is used in {other} as well")
    subs = {each.symbol for each in found if each.symbol.sort not in _LOCAL}
    return {symbol.name for symbol in subs - defined}


def _sequence(numbering: Numbering, count: int, taken: set[int] | None = None) -> list[int]:
    """So many numbers in steps as large as there is room for, without those that are taken."""
    taken = taken or set()
    most = numbering.largest - numbering.first
    step = next((each for each in (numbering.step, 5, 2, 1) if each * (count + len(taken)) <= most), 0)
    if not step:
        raise Cannot(f"there are more lines than numbers up to {numbering.largest}")
    step = min(step, numbering.step)
    found: list[int] = []
    number = numbering.first
    while len(found) < count:
        if number not in taken:
            found.append(number)
        number += step
    return found


def _edit(number: _Number, new: int) -> Edit:
    start, end = number.span
    return Edit(Pos(number.line, start), Pos(number.line, end), str(new))


def _proven(view: View, edits: list[Edit]) -> Work[tuple[Edit, ...]]:
    """The edits that change anything."""
    changing = tuple(edit for edit in edits if _text(view, edit) != edit.text)
    if changing:
        after = applied(view.document, changing)
        _same_brackets(view, after.brackets())
        yield from proving(view, after)
    return changing


def _text(view: View, edit: Edit) -> str:
    return view.document.line(edit.start.line)[edit.start.col : edit.end.col]


def _same_brackets(view: View, after: Iterator[tuple[int, Bracket]]) -> None:
    """Cannot, unless the same blocks open and close on the same lines, each label everywhere the same other one."""
    table: dict[str | None, str | None] = {}
    for (line, was), (at, now) in zip(view.document.brackets(), after):
        same = (line, was.role, was.kind) == (at, now.role, now.kind)
        if not same or table.setdefault(was.label, now.label) != now.label:
            raise Cannot("the blocks would be others")
