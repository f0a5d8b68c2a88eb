"""Bracket that is never closed.

A conditional bracket, or the body of `#IF`, `#ELSE` or `#REPEAT`, ends at its `>`. It cannot
reach beyond its section, so everything up to the section's end would belong to it.

Source: spec/cgt.md §5.2, §7

Bad:

    <X#XPOS
    ^

Bad:

    #REPEAT(3)
    <
    ^
    M08

Good:

    <X#XPOS
    >
"""

from collections.abc import Iterator

from deburr.rule import Report, Severity, Structure, rule
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.ERROR, Structure((Fault.UNCLOSED,)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the opener."""
    yield Report(
        fault.at.bracket.span, "this `<` is never closed; a `>` is missing before the section ends", fault.at.line
    )
