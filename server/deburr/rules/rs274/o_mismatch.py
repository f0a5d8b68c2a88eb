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

from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import end, label, note, said
from deburr_grammar.structure import Fault

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report ends and branches that belong to another block than the one they stand in."""
    for fault in analysis.document.faults:
        if fault.fault in (Fault.MISMATCH, Fault.REGION_MISMATCH) and fault.other is not None:
            bracket, opener = fault.at.bracket, fault.other.bracket
            message = f"{said(bracket)} cannot close {said(opener)}; {end(opener)} is expected"
            yield Report(bracket.span, message, fault.at.line, (note(fault.other, "is open here"),))
    for scope in analysis.scopes:
        for placed, around in scope.brackets():
            bracket = placed.bracket
            opener = next((block.opener for block in reversed(around) if block.opener.bracket.kind == "if"), None)
            if bracket.word in ("else", "elseif") and opener is not None:
                labels = {bracket.label, opener.bracket.label}
                if len(labels - {None}) > 1:
                    message = f"{said(bracket)} stands in {said(opener.bracket)}; `{label(opener.bracket)} {bracket.word}` is expected"
                    yield Report(bracket.span, message, placed.line, (note(opener, "is open here"),))
