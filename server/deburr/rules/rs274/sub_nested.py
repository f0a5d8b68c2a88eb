"""Subprogram defined inside another.

Definitions do not nest; the control stops with "Nested subroutine definition", and some versions
silently do the wrong thing.

Source: spec/rs274.md §6

Bad:

    o1 sub
    o2 sub
    ^^^^^^
    o2 endsub
    o1 endsub

Good:

    o1 sub
    o1 endsub
    o2 sub
    o2 endsub
    o1 call
    o2 call
"""

from collections.abc import Iterator

from deburr.rule import Report, Severity, Structure, rule
from deburr.rules.rs274._o_words import end, note, said
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.ERROR, Structure((Fault.REGION_NESTED,)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the inner definition."""
    assert fault.other is not None
    inner, outer = fault.at.bracket, fault.other.bracket
    message = f"{said(inner)} stands inside {said(outer)}; {end(outer)} must come first"
    yield Report(inner.span, message, fault.at.line, (note(fault.other, "is open here"),))
