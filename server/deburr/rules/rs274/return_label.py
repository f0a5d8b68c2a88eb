"""`return` that names another subprogram.

The interpreter does not look at the label: `return` leaves the subprogram that it stands in,
whatever it names. One that names neither this subprogram nor a block around it, as is the custom
too, was copied or mistyped.

Source: spec/rs274.md §6

Bad:

    o<slot> sub
      o<pocket> return
      ^^^^^^^^^^^^^^^^
    o<slot> endsub
    o<slot> call

Good:

    o<slot> sub
      o1 if [#1 LE 0]
        o1 return
      o1 endif
      o<slot> return [3]
    o<slot> endsub
    o<slot> call [5]
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import outward, ready
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import note, said

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.WARNING, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every `return` whose label is not that of the subprogram or of a block around it."""
    for scope in analysis.scopes:
        for placed, inside in scope.middles if scope.start else ():
            assert scope.start is not None
            around = {scope.start.bracket.label, *(block.opener.bracket.label for block in outward(inside))}
            label = placed.bracket.label
            if placed.bracket.word == "return" and label is not None and around.isdisjoint((label, None)):
                message = f"{said(placed.bracket)} leaves {said(scope.start.bracket)}, whatever it names"
                yield Report(placed.bracket.span, message, placed.line, (note(scope.start),))


def fix(broken: Broken) -> Iterator[Fix]:
    """Name the subprogram that it leaves."""
    label = broken.quoted[1].rpartition(" ")[0]
    yield broken.replaced(f"{label} return", safe=True)
