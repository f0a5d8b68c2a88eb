"""Branch after `else`.

A second `else`, or an `elseif` after `else`, is accepted and never runs.

Source: spec/rs274.md §6

Bad:

    #1=0
    o1 if [#1]
    o1 else
    o1 else
    ^^^^^^^
    o1 endif

Bad:

    #1=0
    o1 if [#1]
    o1 else
    o1 else if [#1 LT 3]
    ^^^^^^^^^^
    o1 endif

Good:

    #1=0
    o1 if [#1]
    o1 elseif [#5420 LT 3]
    o1 else
    o1 endif
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import ready
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import note, said

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.WARNING, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every branch behind the first `else` of a block."""
    for scope in analysis.scopes:
        for block in scope.blocks:
            branches = [placed for placed in block.middles if placed.bracket.word in ("else", "elseif")]
            first = next((at for at, placed in enumerate(branches) if placed.bracket.word == "else"), len(branches))
            for placed in branches[first + 1 :]:
                message = f"{said(placed.bracket)} comes after the `else` of its block and never runs"
                yield Report(placed.bracket.span, message, placed.line, (note(branches[first]),))
