"""A constant in the place of its name: a variable that is set once, to a number, before everything that uses it. Refuses where that cannot be seen, and by proof."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.fix import applied
from deburr.ide.proof import proving
from deburr.ide.refactor import Cannot, Constant, Moves, Work, moves_of
from deburr.ide.related import uses, where
from deburr.symbols import Act, Sort, Symbol, entry_of
from deburr.symbols.index import Placed, all_symbols, at, mentions_of
from deburr_grammar.dialect import Role
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from deburr.ide.view import View


def could_inline(view: View, pos: Pos) -> str:
    """The name at a place of which it is worth asking; nothing: "". Looks at the line alone."""
    placed = at(view.document, pos.line, pos.col)
    if placed is None or moves_of(view.dialect.name) is None or placed.mention.symbol.sort is not Sort.VARIABLE:
        return ""
    start, end = placed.mention.span
    return view.document.line(pos.line)[start:end]


def inlined(view: View, pos: Pos) -> Work[tuple[Edit, ...]]:
    """The edits that put the number where the name at a place is used, and take its setting out; Cannot where that would mean something else."""
    placed, moves = at(view.document, pos.line, pos.col), moves_of(view.dialect.name)
    if placed is None or moves is None or placed.mention.symbol.sort is not Sort.VARIABLE:
        raise Cannot("nothing here is a variable")
    setting, reads = _uses(view, placed)
    constant = moves.constant(view.document.node(setting.line), setting.mention)
    if constant is None:
        raise Cannot("it is not set to a number that can be seen, or not whenever its line is reached")
    _refuse(view, setting, reads, placed.mention.symbol)
    edits = [_put(view, moves, each, constant.value) for each in reads]
    edits += [_without(view, setting.line, constant)] if constant.goes else []
    yield from proving(view, applied(view.document, edits))
    return tuple(edits)


def _uses(view: View, placed: Placed) -> tuple[Placed, list[Placed]]:
    """The one place that sets a variable, and those that use it; Cannot if there is not one, or any in another file."""
    symbol = placed.mention.symbol
    known = entry_of(symbol, view.dialect.codes)
    if known is not None and known.more.get("known") != "program":
        raise Cannot(f"the machine knows it: {known.title}")
    found = list(uses(view, symbol, placed.region))
    if other := next((each.file for each, _ in found if each.file != view.file), ""):
        raise Cannot(f"{other} uses it as well")
    settings = [one for _, one in found if one.mention.act is Act.SET]
    if len(settings) != 1:
        raise Cannot("it is not set" if not settings else f"it is set in {len(settings)} places")
    reads = [one for _, one in found if one.mention.act is not Act.SET]
    if not reads:
        raise Cannot("nothing uses it")
    return settings[0], reads


def _refuse(view: View, setting: Placed, reads: list[Placed], symbol: Symbol) -> None:
    """Cannot, unless the setting runs before all that uses it."""
    if any(
        (each.line, each.mention.span) < (setting.line + 1, setting.mention.span)
        for each in reads
        if each.line <= setting.line
    ):
        raise Cannot(f"it is used before it is set in line {setting.line + 1}, or on that line")
    unknown = Symbol(symbol.sort, "")
    if symbol.name.isdigit() and any(next(mentions_of(each.document, unknown), None) for each in where(view, symbol)):
        raise Cannot("a number of this sort is computed somewhere, so who else uses it cannot be seen")
    depth = 0
    for line, bracket in view.document.brackets():
        if line >= setting.line:
            break
        depth += (bracket.role is Role.OPEN) - (bracket.role is Role.CLOSE)
    if depth:
        raise Cannot("it is set in a block, which may not run")
    if _reached_otherwise(view, setting.line):
        raise Cannot("jumps may pass the line that sets it")


def _reached_otherwise(view: View, line: int) -> bool:
    """Whether a jump or a call stands before a line."""
    symbols = [each for each in all_symbols(view.document) if each.sort in (Sort.LABEL, Sort.SECTION)]
    calls = (one for each in symbols if not each.local for one in mentions_of(view.document, each))
    return any(one.mention.act is Act.CALL and one.line < line for one in calls)


def _put(view: View, moves: Moves, place: Placed, value: str) -> Edit:
    start, end = place.mention.span
    text = moves.inlined(value, view.document.node(place.line), place.mention)
    return Edit(Pos(place.line, start), Pos(place.line, end), text)


def _without(view: View, line: int, constant: Constant) -> Edit:
    """The line without the setting; nothing of it where it held nothing else."""
    start, end = constant.span
    text = view.document.line(line)
    if not text[:start].strip() and not text[end:].strip() and line + 1 < view.document.line_count:
        return Edit(Pos(line, 0), Pos(line + 1, 0), "")
    return Edit(Pos(line, start), Pos(line, end), "")
