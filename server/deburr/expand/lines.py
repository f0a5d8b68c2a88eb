"""What rules on lines say of a stretch of a program that is about to run. Keeps nothing: a run reads each line's form once."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr_grammar.text import with_newlines

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.rule import Report, Rule
    from deburr.ruleset import RuleSet
    from deburr_grammar.document import Piece


def reports(piece: Piece, rules: RuleSet) -> Iterator[tuple[int, Rule, Report]]:
    """What the rules say of a piece, with the lines counted from its first."""
    for index, reading, shape in piece.where(lambda reading, shape: rules.plan(shape, reading)):
        for rule, report in rules.on_line(piece.node(index), rules.plan(shape, reading)):
            yield index, rule, report
    text = with_newlines(piece.chunk.text)
    for rule, searched in rules.on_text:
        for index in searched.lines(text):
            node = piece.node(index)
            for found, report in rules.on_line(node, (rule,)) if node.reading.start is not None else ():
                yield index, found, report
