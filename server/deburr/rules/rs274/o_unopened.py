"""End of a block that was never opened.

An `endif`, `endwhile`, `endrepeat`, `else` or `elseif` with no block to belong to stops the control
with "undefined O-word label" when it is reached.

Source: spec/rs274.md §6

Bad:

    o1 endif
    ^^^^^^^^

Bad:

    o1 while [0]
      o2 else
      ^^^^^^^
    o1 endwhile

Good:

    o1 if [1]
    o1 else
    o1 endif
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import outward, ready
from deburr.fixers import line_deleted
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import label, misspelt, said
from deburr_grammar.structure import Fault

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report closers without an opener, and branches without an `if` around them."""
    for fault in analysis.document.faults:
        if fault.fault is Fault.UNOPENED and not misspelt(fault.at.bracket):
            bracket = fault.at.bracket
            yield Report(bracket.span, f"{said(bracket)} closes nothing; no block is open here", fault.at.line)
    for scope in analysis.scopes:
        for placed, inside in scope.middles:
            bracket = placed.bracket
            branch = bracket.word in ("else", "elseif")
            if branch and not any(block.opener.bracket.kind == "if" for block in outward(inside)):
                message = f"{said(bracket)} belongs to no `if`; `{label(bracket)} if` is missing"
                yield Report(bracket.span, message, placed.line)


fix = line_deleted
