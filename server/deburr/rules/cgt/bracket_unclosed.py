"""Bracket that is never closed.

A conditional bracket, or the body of `#IF`, `#ELSE` or `#REPEAT`, ends at its `>`. It cannot
reach beyond its section, so everything up to the section's end would belong to it.

Source: spec/cgt.md §5.2, §7

Bad:

    <#MOV>< X#XPOS>< Y#YPOS>< Z#ZPOS
                            ^

Bad:

    #REPEAT(3)
    <
    ^
    M08

Bad (whole):

    @START
    <T#TOOL
    ^
    @
    @END
    M30>
    @

Good:

    <X#XPOS
    >
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Note, Report, Severity, Structure, rule
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.ERROR, Structure((Fault.UNCLOSED, Fault.ACROSS)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the opener; a closer in a later section cannot be its own."""
    message = "this `<` is never closed; a `>` is missing before the section ends"
    other = fault.other
    related = (Note(other.line, other.bracket.span, "this `>` stands in another section"),) if other else ()
    yield Report(fault.at.bracket.span, message, fault.at.line, related)


def fix(broken: Broken) -> Iterator[Fix]:
    """Close it where its line ends, if there is anything in it."""
    end = len(broken.text.rstrip())
    if end > broken.span.end:
        yield broken.inserted(end, ">")
