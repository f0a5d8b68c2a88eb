"""Bracket that closes nothing.

Outside the parentheses of a command `<` and `>` are always brackets; neither can be output.

Source: spec/cgt.md §2, §7

Bad:

    <#MOV> X#XPOS>
                 ^

Good:

    <X#XPOS>
    #IF(#V1>3)<M08>
"""

from collections.abc import Iterator

from deburr.fixers import deleted
from deburr.rule import Report, Severity, Structure, rule
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.ERROR, Structure((Fault.UNOPENED,)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the closer."""
    yield Report(
        fault.at.bracket.span, "this `>` closes nothing; no `<` stands before it in the section", fault.at.line
    )


fix = deleted
