"""A constant in the place of its name: a variable that is set once, to a number, before everything that uses it. Refuses where that cannot be seen, and by proof."""

from __future__ import annotations

from decimal import Decimal
from typing import TYPE_CHECKING, NamedTuple

from deburr.fix import applied
from deburr.ide.known import known
from deburr.ide.proof import proving
from deburr.ide.refactor import Cannot, Moves, Work, moves_of
from deburr.ide.related import uses, where
from deburr.symbols import Act, Sort, Symbol, entry_of
from deburr.symbols.constants import constants_of
from deburr.symbols.index import Placed, all_symbols, at, mentions_of
from deburr_grammar.dialect import Role
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.text import Span


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
    uses = _uses(view, placed)
    found = _given(view, moves, placed, uses) or _set(view, moves, placed, uses)
    yield from proving(view, applied(view.document, found))
    return tuple(found)


def _given(view: View, moves: Moves, placed: Placed, uses: _Uses) -> list[Edit]:
    """The edits for a value that the program's configuration gives; it stays there. None of what the program itself counts or sets."""
    constants, symbol = constants_of(view.dialect.name), placed.mention.symbol
    value = constants.given(symbol, view.file, view.ruleset.settings, view.host) if constants is not None else None
    if value is None or value.plain is None:
        return []
    if uses.settings:
        raise Cannot(f"a loop counts it in line {uses.settings[0].line + 1}")
    return [_put(view, moves, each, value.plain) for each in uses.reads]


def _set(view: View, moves: Moves, placed: Placed, uses: _Uses) -> list[Edit]:
    """The edits for a number that one line sets."""
    settings, reads = uses.settings, uses.reads
    if len(settings) != 1:
        raise Cannot("it is not set" if not settings else f"it is set in {len(settings)} places")
    if not reads:
        raise Cannot("nothing uses it")
    setting = settings[0]
    constant = moves.constant(view.document.node(setting.line), setting.mention)
    if constant is None:
        raise Cannot("it is not set to a number that can be seen, or not whenever its line is reached")
    if moves.IN_ORDER:
        _refuse(view, setting, reads, placed.mention.symbol)
    elif not all(_holds(view, each, constant.value) for each in reads):
        raise Cannot(f"it may hold something else where it is used: {constant.value} is not proven of it")
    edits = [_put(view, moves, each, constant.value) for each in reads]
    if constant.goes:
        gone = [(setting.line, constant.span)]
        gone += [(one.line, moves.undeclared(view.document.node(one.line), one.mention)) for one in uses.declared]
        edits += [_without(view, *each) for each in gone]
    return edits


class _Uses(NamedTuple):
    """The places of a variable in its program: where it is declared, where it is set, and all others."""

    declared: list[Placed]
    settings: list[Placed]
    reads: list[Placed]


def _uses(view: View, placed: Placed) -> _Uses:
    """All places of a variable; Cannot if any is in another file, or the machine has a say."""
    symbol = placed.mention.symbol
    known = entry_of(symbol, view.dialect.codes)
    if known is not None and known.more.get("known") != "program":
        raise Cannot(f"the machine knows it: {known.title}")
    found = list(uses(view, symbol, placed.region))
    if other := next((each.file for each, _ in found if each.file != view.file), ""):
        raise Cannot(f"{other} uses it as well")
    by_act = {act: [one for _, one in found if one.mention.act is act] for act in Act}
    reads = [one for _, one in found if one.mention.act not in (Act.DEFINE, Act.SET)]
    return _Uses(by_act[Act.DEFINE], by_act[Act.SET], reads)


def _holds(view: View, place: Placed, value: str) -> bool:
    """Whether a name holds a number at a place, and no other."""
    found = known(view, place)
    return found is not None and found.plain is not None and _number(found.plain) == _number(value)


def _number(text: str) -> Decimal | None:
    try:
        return Decimal(text)
    except ArithmeticError:
        return None


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


def _without(view: View, line: int, stretch: Span) -> Edit:
    """A line without a stretch; nothing of it where it held nothing else."""
    start, end = stretch
    text = view.document.line(line)
    if not text[:start].strip() and not text[end:].strip() and line + 1 < view.document.line_count:
        return Edit(Pos(line, 0), Pos(line + 1, 0), "")
    return Edit(Pos(line, start), Pos(line, end), "")
