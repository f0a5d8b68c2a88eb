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
    for reading, first, shapes in piece.read():
        plans = {shape: plan for shape in set(shapes) if (plan := rules.plan(shape, reading))}
        for index in (at for at, shape in enumerate(shapes, first) if shape in plans) if plans else ():
            for rule, report in rules.on_line(piece.node(index), plans[shapes[index - first]]):
                yield index, rule, report
    text = with_newlines(piece.chunk.text)
    for rule, pattern in rules.on_text:
        for index in dict.fromkeys(text.count("\n", 0, match.start()) for match in pattern.finditer(text)):
            node = piece.node(index)
            for found, report in rules.on_line(node, (rule,)) if node.reading.start is not None else ():
                yield index, found, report
