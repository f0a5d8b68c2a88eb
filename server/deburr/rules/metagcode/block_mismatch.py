"""End that does not match the innermost open block.

Blocks nest and never overlap, so an end must carry the word and the number of the block that was
opened last. Numbers are compared as text: `1` is not `01`.

Source: spec/metagcode.md §4, §6, §10

Bad:

    #IF1 |a| equalto 1 n
    #ENDIF2
    ^^^^^^^

Bad:

    #IF1 |a| equalto 1 n
    #LOOP1 |z| 2 c
    G1 Z|z|
    #ENDIF1
    ^^^^^^^
    #ENDLOOP1

Bad:

    #IF1 |a| equalto 1 n
    #FILE close.txt
    ^^^^^^^^^^^^^^^
    -- Snippets/close.txt --
    #ENDIF01

Good:

    #IF1 |a| equalto 1 n
    #LOOP1 |z| 2 c
    G1 Z|z|
    #ENDLOOP1
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import advised
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, end_of, gathered, ready, said
from deburr_grammar.structure import Fault


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the end, or the line that brings it in."""
    blocks = gathered(analysis)
    for fault in blocks.faults:
        if fault.fault not in (Fault.MISMATCH, Fault.CROSSED) or fault.other is None:
            continue
        line, span = blocks.place(fault.at)
        closer, opener = fault.at.bracket, fault.other.bracket
        related = (*((closer.note,) if isinstance(closer, Foreign) else ()), blocks.note(fault.other))
        hint = f"the two blocks overlap, so `{end_of(opener)}` must come first"
        if fault.fault is Fault.MISMATCH:
            hint = f"write `{end_of(opener)}`"
        message = f"`{said(closer)}` cannot close `{said(opener)}`, the innermost open block; {hint}"
        yield Report(span, message, line, related)


fix = advised
