"""End of another block than the one that is open.

A block ends with the word of its kind and its own label. The control stops with "no matching label"
or looks for the right end down to the end of the file.

Source: spec/rs274.md §6

Bad:

    o1 do
      G0 X1
    o1 endwhile
    ^^^^^^^^^^^

Bad:

    o1 if [1]
    o2 endif
    ^^^^^^^^

Bad:

    o1 if [1]
    o2 else
    ^^^^^^^
    o1 endif

Bad:

    o<drill> sub
    o<dril> endsub
    ^^^^^^^^^^^^^^

Good:

    o<1> if [1]
    O01 ENDIF
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import outward, ready
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import end, label, misspelt, note, said
from deburr_grammar.structure import Fault, Placed

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report ends and branches that belong to another block than the one they stand in."""
    for fault in analysis.document.faults:
        if fault.fault in (Fault.MISMATCH, Fault.REGION_MISMATCH) and fault.other is not None:
            bracket, opener = fault.at.bracket, fault.other.bracket
            if misspelt(bracket) or misspelt(opener):
                continue
            message = f"{said(bracket)} cannot close {said(opener)}; {end(opener)} is expected"
            yield Report(bracket.span, message, fault.at.line, (note(fault.other, "is open here"),))
    for scope in analysis.scopes:
        for placed, inside in scope.middles:
            start = next((block.opener for block in outward(inside) if block.opener.bracket.kind == "if"), None)
            if placed.bracket.word in ("else", "elseif") and start is not None:
                yield from _branch(placed, start)


def _branch(placed: Placed, start: Placed) -> Iterator[Report]:
    bracket, opener = placed.bracket, start.bracket
    if len({bracket.label, opener.label} - {None}) > 1:
        message = f"{said(bracket)} stands in {said(opener)}; `{label(opener)} {bracket.word}` is expected"
        yield Report(bracket.span, message, placed.line, (note(start, "is open here"),))


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the end that is expected."""
    if "is expected" in broken.finding.message and broken.quoted[0] == broken.said:
        yield broken.replaced(broken.quoted[-1])
