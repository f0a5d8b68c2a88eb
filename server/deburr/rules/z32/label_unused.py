"""Block number that nothing jumps to.

Block numbers are optional; one that no jump uses only costs memory. This rule is off unless it is
selected.

Source: spec/z32.md §1

Bad:

    N10 G0 X1
    ^^^
    !GON20!
    N20 G0 X2

Good:

    !GON10-N20!
    N10 G0 X1
    N20
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import deleted
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._program import all_labels, entries, jumps, ready_jumps


@rule(Severity.INFO, Whole(ready_jumps), default=False)
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the numbers; where a jump is calculated any could be used."""
    reached, found = entries(analysis), jumps(analysis)
    if reached is None or any(jump.end_span is not None and jump.end is None for jump in found):
        return
    used = reached | {jump.end for jump in found}
    for value, label in all_labels(analysis):
        if value not in used:
            yield Report(label.span, "nothing jumps to this block number", label.line)


fix = deleted
