"""Blocks that overlap.

A block that starts inside another must end inside it. The control runs overlapping blocks without
complaint, jumping from label to label; no one means what it then does.

Source: spec/rs274.md §6

Bad:

    o1 if [1]
    o2 if [1]
    o1 endif
    ^^^^^^^^
    o2 endif

Good:

    o1 if [1]
    o2 if [1]
    o2 endif
    o1 endif
"""

from collections.abc import Iterator

from deburr.rule import Report, Severity, Structure, rule
from deburr.rules.rs274._o_words import note, said
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.WARNING, Structure((Fault.CROSSED,)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the end that comes too early."""
    bracket = fault.at.bracket
    assert fault.other is not None
    message = f"{said(bracket)} comes before the end of {said(fault.other.bracket)}; the two blocks overlap"
    yield Report(bracket.span, message, fault.at.line, (note(fault.other, "is still open"),))
