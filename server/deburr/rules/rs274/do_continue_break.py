"""`continue` in a `do` loop that also has a `break` further down.

By the manual `continue` goes on with the loop's condition. The interpreter, on its way down to it,
takes a `break` of the same loop for its own, and the loop ends there.

Source: spec/rs274.md §6

Bad:

    #1=0
    o1 do
      #1=[#1+1]
      o2 if [#1 EQ 2]
        o1 continue
        ^^^^^^^^^^^
      o2 endif
      o3 if [#1 GT 5]
        o1 break
      o3 endif
    o1 while [#1 LT 4]

Good:

    #1=0
    o1 do
      #1=[#1+1]
      o3 if [#1 GT 5]
        o1 break
      o3 endif
      o2 if [#1 EQ 2]
        o1 continue
      o2 endif
    o1 while [#1 LT 4]

Good:

    o1 while [#1 LT 4]
      #1=[#1+1]
      o2 if [#1 EQ 2]
        o1 continue
      o2 endif
      o3 if [#1 GT 5]
        o1 break
      o3 endif
    o1 endwhile
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import Block, outward, ready
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import note, said
from deburr_grammar.structure import Placed

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.WARNING, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every `continue` of a `do` loop behind which the loop has a `break`."""
    for scope in analysis.scopes:
        last: dict[Block, Placed] = {}
        for placed, inside in reversed(scope.middles):
            word = placed.bracket.word
            loop = _loop(placed, inside) if word in ("break", "continue") else None
            if loop is None or loop.opener.bracket.kind != "do":
                continue
            if word == "break":
                last[loop] = placed
            elif loop in last:
                message = f"{said(placed.bracket)} ends the loop here: the interpreter meets {said(last[loop].bracket)} on its way down and takes it"
                yield Report(placed.bracket.span, message, placed.line, (note(last[loop]),))


def _loop(placed: Placed, inside: Block | None) -> Block | None:
    """The loop that a `break` or `continue` names, if its label says so for certain."""
    label = placed.bracket.label
    loops = (block for block in outward(inside) if block.opener.bracket.kind in ("do", "while"))
    return next((loop for loop in loops if label is not None and loop.opener.bracket.label == label), None)
