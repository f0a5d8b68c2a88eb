"""What is shown within lines: values, lengths of loops, rows of tables and aliases where they are certain. Looks at no more lines than it is asked for."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from deburr.ide.known import held, known, passes
from deburr.symbols import Act, Sort, language_of
from deburr.symbols.constants import constants_of
from deburr.symbols.index import Placed, on_line, region

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols import Mention
    from deburr.symbols.constants import Length
    from deburr_grammar.text import Span

KINDS = frozenset(("passes", "values", "rows", "alias"))
_LONGEST = 24
"""Longer texts would push the program out of sight."""


class Hint(NamedTuple):
    """A text behind a place, and the kind under which it can be switched off."""

    line: int
    col: int
    text: str
    kind: str


def hints(view: View, first: int, last: int, kinds: Collection[str] = KINDS) -> Iterator[Hint]:
    """The hints of some lines, both included, from left to right."""
    for line in range(max(0, first), min(last, view.document.line_count - 1) + 1):
        if view.document.line(line):
            yield from sorted(each for each in _of_line(view, line, kinds) if len(each.text) <= _LONGEST)


def _of_line(view: View, line: int, kinds: Collection[str]) -> Iterator[Hint]:
    language, constants = language_of(view.dialect.name), constants_of(view.dialect.name)
    if language is None or constants is None or view.document.node(line).reading.start is None:
        return
    settings = view.ruleset.settings
    lengths = list(constants.lengths(view.document, line, partial(held, view), settings)) if "passes" in kinds else []
    turns = passes(view, line) if "passes" in kinds and not lengths and _tests(view, line) else None
    yield from (Hint(line, each.span.end, each.text, "passes") for each in lengths)
    yield from [] if turns is None else [Hint(line, turns[0].end, turns[1], "passes")]
    for mention in on_line(view.document, line):
        end = mention.span.end
        meant = language.meant(view.document, line, mention) if "alias" in kinds else None
        row = constants.row(view.document, line, mention) if "rows" in kinds else None
        if meant is not None:
            yield Hint(line, end, f"={meant.text}", meant.kind)
        elif row is not None:
            yield Hint(line, end, f"={row}", "rows")
        elif "values" in kinds and not _within(mention.span, lengths):
            value = _value(view, line, mention)
            yield from [] if value is None else [Hint(line, end, f"={value}", "values")]
    for span, result in constants.results(view.document.node(line), settings) if "values" in kinds else ():
        if not _within(span, lengths):
            yield Hint(line, span.end, f"={result}", "values")


def _tests(view: View, line: int) -> bool:
    """Whether a loop's condition may stand on a line: a loop opens or ends there, or a jump may lead back from it."""
    piece = view.document.piece(line)
    brackets = (bracket for index, bracket in piece.outlined.brackets if piece.line + index == line)
    if any(bracket.kind in ("while", "do") for bracket in brackets):
        return True
    return any(each.symbol.sort is Sort.LABEL and each.act is not Act.DEFINE for each in on_line(view.document, line))


def _within(span: Span, lengths: Iterable[Length]) -> bool:
    """Whether a stretch is what a length was worked out from."""
    return any(each.span.start <= span.start and span.end <= each.span.end for each in lengths)


def _value(view: View, line: int, mention: Mention) -> str | None:
    """What is read there, if it is one value."""
    if mention.act is not Act.READ or mention.passing:
        return None
    where = region(view.document, line) if mention.symbol.local else None
    value = known(view, Placed(line, mention, where))
    return None if value is None else value.plain
