"""Block that is never closed.

Every `#IF` needs its `#ENDIF` and every `#LOOP` its `#ENDLOOP`, in the program or in a snippet that
it includes. Without it all that follows belongs to the block, so nothing is built.

Source: spec/metagcode.md §4, §6

Bad:

    #IF1 |a| equalto 1 n
    ^^^^
    G0 X1

Bad:

    #IF1 |a| equalto 1 n
    #LOOP1 |z| 2 c
    ^^^^^^
    G1 Z|z|
    #ENDIF1

Bad:

    #LOOP1 |y| 10 c
    #LOOP2 |z| 2 c
    #IF1 |a| equalto 1 n
    ^^^^
    G1 Y|y| Z-|z|
    #ENDLOOP2
    #ENDLOOP1

Bad:

    #FILE open.txt
    ^^^^^^^^^^^^^^
    G0 X1
    -- Snippets/open.txt --
    #IF1 |a| equalto 1 n

Good:

    #IF1 |a| equalto 1 n
    G0 X1
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.blockfix import ended
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, end_of, gathered, ready, said
from deburr_grammar.structure import Fault


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the opener, or the line that brings it in. What a snippet leaves open its caller may close."""
    blocks = gathered(analysis)
    for fault in blocks.faults:
        if fault.fault is not Fault.UNCLOSED or (fault.other is None and blocks.library.inside):
            continue
        line, span = blocks.place(fault.at)
        opener = fault.at.bracket
        foreign = (opener.note,) if isinstance(opener, Foreign) else ()
        other = (blocks.note(fault.other),) if fault.other is not None else ()
        where = f" before `{said(fault.other.bracket)}`" if fault.other is not None else ""
        message = f"`{said(opener)}` is never closed; `{end_of(opener)}` is missing{where}"
        yield Report(span, message, line, (*foreign, *other))


def fix(broken: Broken) -> Iterator[Fix]:
    """Add the missing end."""
    if broken.said == broken.quoted[0]:
        yield from ended(broken, broken.quoted[1])
