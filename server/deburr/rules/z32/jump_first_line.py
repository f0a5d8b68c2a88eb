"""Jump to the first line of the program.

The control does not look at the first line when it searches for a block number. A comment
before it is enough.

Source: spec/z32.md §1, §6.3

Bad (whole):

    N1 G0 X1
    !GON1!
        ^
    M30

Bad (whole):

    POCKET
    %
    N1 G0 X1
    !GON1!
        ^
    M30

Good:

    N1 G0 X1
    !GON1!
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._program import first_line, jumps, labels, ready_jumps


@rule(Severity.WARNING, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number that is jumped to."""
    found = jumps(analysis)
    first = first_line(analysis) if found else None
    for jump in found:
        places = labels(analysis, jump.target) if jump.target is not None else []
        if len(places) == 1 and places[0].line == first and jump.target is not None:
            message = f"N{shown(jump.target)} is the first line of the program, where the control does not look; put a line before it"
            yield Report(jump.target_span, message, jump.line, (Note(first, places[0].span, "the first line"),))
