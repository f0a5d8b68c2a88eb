"""End of a block that was never opened.

There is no block to close at an `#ENDIF` or `#ENDLOOP`: the opener is missing, or one end is too
many. Where the block should have begun cannot be told, so nothing is built.

Source: spec/metagcode.md §4, §6

Bad:

    #ENDLOOP1
    ^^^^^^^^^

Bad:

    #IF1 |a| equalto 1 n
    #ENDIF1
    #ENDIF1
    ^^^^^^^

Bad:

    #LOOP1 |z| 2 c
    #IF1 |a| equalto 1 n
    G1 Z-|z|
    #ENDIF1
    #ENDIF1
    ^^^^^^^
    #ENDLOOP1

Bad:

    #FILE close.txt
    ^^^^^^^^^^^^^^^
    -- Snippets/close.txt --
    #ENDIF1

Good:

    #LOOP1 |z| 2 c
    G1 Z|z|
    #ENDLOOP1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import line_deleted
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, gathered, ready, said
from deburr_grammar.structure import Fault


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the end, or the line that brings it in. What a snippet closes its caller may have opened."""
    blocks = gathered(analysis)
    for fault in blocks.faults:
        if fault.fault is not Fault.UNOPENED or blocks.library.inside:
            continue
        line, span = blocks.place(fault.at)
        closer = fault.at.bracket
        opener = f"#{closer.word[4:]}{closer.label or ''}"
        related = (closer.note,) if isinstance(closer, Foreign) else ()
        yield Report(span, f"`{said(closer)}` closes nothing; no `{opener}` is open here", line, related)


def fix(broken: Broken) -> Iterator[Fix]:
    """Delete the line, if it is the end itself and not a snippet that brings it."""
    if broken.said == broken.quoted[0]:
        yield from line_deleted(broken)
