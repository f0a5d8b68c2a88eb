"""Jump with a return from a block that there is not.

GONn-Nm comes back when block m has been run; without it the program runs on to its end, and what
stands behind the jump is not done.

Source: spec/z32.md §6.3

Bad:

    !GON1-N2!
          ^^
    N1 G0 X1

Good:

    !GON1-N2!
    N1 G0 X1
    N2
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._nearest import meant
from deburr.rules.z32._program import jumps, labels, ready_jumps


@rule(Severity.ERROR, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number of the last block."""
    for jump in jumps(analysis):
        if jump.end is not None and jump.end_span is not None and not labels(analysis, jump.end):
            message = f"no block has the number N{shown(jump.end)}, so the program never comes back from this jump"
            yield Report(jump.end_span, message + meant(analysis, jump.end), jump.line)
