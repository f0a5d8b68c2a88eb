"""Jump to a block number that no block has.

The control stops when it does not find the number in the program. N150 and N150.0 are the same.

Source: spec/z32.md §6.3

Bad:

    !GON150!
        ^^^
    !IF HA>1; GON11-N20! HA=2!
                 ^^
    N20

Good:

    !GON150!
    N150.0 G0 X1
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._nearest import meant
from deburr.rules.z32._program import jumps, labels, ready_jumps


@rule(Severity.ERROR, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number that is jumped to."""
    for jump in jumps(analysis):
        if jump.target is not None and not labels(analysis, jump.target):
            message = f"no block has the number N{shown(jump.target)}, so the control stops at this jump"
            yield Report(jump.target_span, message + meant(analysis, jump.target), jump.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Go to the nearest number that there is."""
    near = re.search(r"the nearest is N([0-9]+)", broken.finding.message)
    number = re.search(r"[0-9]+$", broken.said)
    if near is not None and number is not None:
        yield broken.replaced(broken.said[: number.start()] + near[1])
