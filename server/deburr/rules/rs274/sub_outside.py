"""End of a subprogram, or return from one, outside all subprograms.

The control stops with "not in a subroutine definition".

Source: spec/rs274.md §6

Bad:

    o1 endsub
    ^^^^^^^^^

Bad:

    o1 return
    ^^^^^^^^^

Good:

    o1 sub
      o1 return [3]
    o1 endsub
    o1 call
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import ready
from deburr.fixers import line_deleted
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import said
from deburr_grammar.structure import Fault

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report ends without a start, and returns in the main program."""
    for fault in analysis.document.faults:
        if fault.fault is Fault.REGION_UNOPENED:
            yield Report(
                fault.at.bracket.span, f"{said(fault.at.bracket)} ends no subprogram; none is open here", fault.at.line
            )
    for placed, _ in analysis.scopes[0].middles:
        if placed.bracket.word == "return":
            yield Report(
                placed.bracket.span,
                f"{said(placed.bracket)} stands in no subprogram; the control stops here",
                placed.line,
            )


fix = line_deleted
