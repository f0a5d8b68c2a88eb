"""What a name holds at a place, where that is certain: the one seam through which hover, hints and lenses learn values. Never runs a program.

A constant is known where its assignment is always run last before the place: it stands above in the
same block or in one around it, and nothing between them can set the name, come in from elsewhere or leave
for a program that may set it. Beyond that a name is known that holds one number on all ways (deburr/values).
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from deburr.analysis import Analysis
from deburr.symbols import Act, Sort, Symbol, entry_of, language_of
from deburr.symbols.constants import Constants, Value, constants_of, count
from deburr.symbols.index import Placed, between, mentions_of, on_line, region
from deburr.values import Told, all_passes, passes_at, told_at, value_at
from deburr.values.words import said
from deburr_grammar.dialect import Bracket, Role

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr_grammar.document import Document
    from deburr_grammar.text import Span

_DEEPEST = 250
_FARTHEST = 20_000
"""So many lines between an assignment and a place are looked through."""
_LEAVING = (Sort.SUB, Sort.SECTION, Sort.FILE)
_MOST = 1_000
"""A name that is set so often has no known value."""

Opener = tuple[int, Bracket]


def known(view: View, placed: Placed) -> Value | None:
    """What a name holds at a place; behind its own assignment what that gives it. None: it is not known."""
    symbol = placed.mention.symbol
    constants = constants_of(view.dialect.name)
    document, line = view.document, placed.line
    # Where blocks do not fit, what is run after what is a guess.
    if constants is None or symbol.sort is not Sort.VARIABLE or not symbol.name or document.faults:
        return None
    total = constants.given(symbol, view.file, view.ruleset.settings, view.host)
    found = constants.counted(document, line, symbol, total, partial(held, view))
    return found or (None if total is not None else _assigned(view, placed, constants) or _proven(view, placed))


def held(view: View, line: int, written: str) -> Value | None:
    """What a name that is written on a line holds before that line's block."""
    language = language_of(view.dialect.name)
    for each in on_line(view.document, line):
        symbol = each.symbol
        if language is not None and symbol.sort is Sort.VARIABLE and written in (symbol.name, language.written(symbol)):
            where = region(view.document, line) if symbol.local else None
            placed = Placed(line, each._replace(act=Act.READ), where)
            found = _before(view, placed)
            told = proven(view, placed) if found is None else None
            return Value(told.number, told.why) if told is not None and told.number is not None else found
    return None


def proven(view: View, placed: Placed) -> Told | None:
    """What a name can hold at a place, whatever the inputs are; None if nothing is proven of it."""
    language = language_of(view.dialect.name)
    if language is None or placed.mention.symbol.sort is not Sort.VARIABLE:
        return None
    written = language.written(placed.mention.symbol)
    with _analysis(view) as analysis:
        return told_at(analysis, placed.line, written, placed.mention.act is Act.SET)


def passes(view: View, line: int) -> tuple[Span, str] | None:
    """How often the loop goes round whose condition stands on a line, in words, and the columns that say so; None if it is not proven."""
    with _analysis(view) as analysis:
        found = passes_at(analysis, line)
    return None if found is None else (found[0], count(found[1]))


def loops(view: View) -> list[tuple[int, Span, str]]:
    """The loops of which it is proven how often they go round: the line of the condition, the columns that say so, how often in words."""
    with _analysis(view) as analysis:
        return [(line, span, count(times)) for line, span, times in all_passes(analysis)]


def _analysis(view: View) -> Analysis:
    return Analysis(view.document, view.ruleset, view.file, view.host)


def _before(view: View, placed: Placed) -> Value | None:
    """What a name holds where a loop begins: what this loop counts is not counted yet."""
    constants = constants_of(view.dialect.name)
    assert constants is not None
    symbol, settings = placed.mention.symbol, view.ruleset.settings
    total = constants.given(symbol, view.file, settings, view.host)
    if total is None:
        return _assigned(view, placed, constants) or _proven(view, placed)
    return constants.counted(view.document, placed.line, symbol, total, lambda *_: None)


def _proven(view: View, placed: Placed) -> Value | None:
    """The one number that a name holds on every way that a program can take to a place."""
    language = language_of(view.dialect.name)
    assert language is not None
    written, behind = language.written(placed.mention.symbol), placed.mention.act is Act.SET
    with _analysis(view) as analysis:
        value = value_at(analysis, placed.line, written, behind)
    return Value(said(value), "on every way to this line") if value is not None and value.exact else None


def _assigned(view: View, placed: Placed, constants: Constants) -> Value | None:
    """The constant that was assigned last before a place."""
    document, symbol, line = view.document, placed.mention.symbol, placed.line
    entry = entry_of(symbol, view.dialect.codes)
    if entry is not None and (entry.more.get("access") == "read" or entry.more.get("known") != "program"):
        return None
    if placed.mention.act is Act.SET:
        text = constants.assigned(document, line, placed.mention, view.ruleset.settings)
        return None if text is None else Value(text, "set here")
    if not is_seen(view, placed):
        return None
    sets = list(islice(mentions_of(document, symbol, placed.region, Act.SET), _MOST))
    last = max((each for each in sets if each.line < line), key=lambda each: each.line, default=None)
    if last is None or not last.mention.symbol.name or len(sets) == _MOST:
        return None
    end = _runs_before(document, last, placed)
    if end is None or any(each is not last and last.line <= each.line <= end for each in sets):
        return None
    # Only the run knows which name these set.
    computed = Symbol(Sort.VARIABLE, "", table="" if entry is None else str(entry.more.get("prefix", "")))
    if any(each.symbol == computed and each.act is Act.SET for _, each in between(document, last.line, end)):
        return None
    if (constants.disturbed(document, last.line + 1, line)) or (
        not symbol.local and _leaves(document, last.line, line)
    ):
        return None
    text = constants.assigned(document, last.line, last.mention, view.ruleset.settings)
    return None if text is None else Value(text, f"line {last.line + 1}")


def is_seen(view: View, placed: Placed) -> bool:
    """Whether all places that name what is named are known, or found without a look at the whole program."""
    return view.is_read or (placed.mention.symbol.local and placed.region is not None)


def _runs_before(document: Document, last: Placed, placed: Placed) -> int | None:
    """The line up to which nothing else may set a name, if an assignment is always the last one that is run before a place."""
    if placed.line - last.line > _FARTHEST or last.mention.symbol.local and last.region != placed.region:
        return None
    if region(document, last.line) != region(document, placed.line):
        return None
    own = list(_around(document, last))
    mine = list(_around(document, placed))
    if own and own[0] not in mine or own and _turns(document, last.line, placed.line):
        return None
    deeper = mine[: mine.index(own[0])] if own else mine
    if not deeper:
        return placed.line
    # A block may be run again: what it sets behind the place is set before it then.
    closer = document.partner(*deeper[-1])
    return None if closer is None else closer[0]


def _around(document: Document, placed: Placed) -> Iterator[Opener]:
    """The openers of the blocks around a place, innermost first."""
    found = document.around(placed.line, placed.mention.span.start)
    for _ in range(_DEEPEST):
        if found is None:
            return
        yield found
        found = document.around(found[0], found[1].span.start)


def _turns(document: Document, first: int, last: int) -> bool:
    """Whether another branch of the block around a line begins before another one."""
    depth = 0
    for _, bracket in _brackets(document, first, last):
        depth += (bracket.role is Role.OPEN) - (bracket.role is Role.CLOSE)
        if bracket.role is Role.MIDDLE and not depth:
            return True
    return False


def _brackets(document: Document, first: int, last: int) -> Iterator[Opener]:
    """The brackets behind a line, up to another one."""
    line = first
    while line <= last:
        piece = document.piece(line)
        yield from (
            (piece.line + index, bracket)
            for index, bracket in piece.outlined.brackets
            if first < piece.line + index <= last
        )
        line = max(line + 1, piece.line + piece.chunk.eols)


def _leaves(document: Document, first: int, last: int) -> bool:
    """Whether something is called between two lines that may set what all programs share."""
    return any(each.act is Act.CALL and each.symbol.sort in _LEAVING for _, each in between(document, first, last))
