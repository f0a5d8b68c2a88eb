"""Range whose last block is never reached.

GONn-Nm comes back when block m has been run. Here every way from block n leads to the end of the
program before block m: the jump never comes back, and what stands behind it is not done.

Source: spec/z32.md §6.3

Bad:

    !GON100-N190!
            ^^^^
    G0 X0 Y0
    M30
    N100 G0 Z-5
    M30
    N190 ;end of the range

Bad:

    N10 ;end of the range
    G0 X1
    !GON20-N10!
           ^^^
    M30
    N20 G0 X2

Good:

    !GON100-N190!
    G0 X0 Y0
    M30
    N100 G0 Z-5
    !IF HA>1; GON190!
    G0 Z-10
    N190 ;end of the range
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._flow import open_ranges, ready_ranges
from deburr.rules.z32._program import labels


@rule(Severity.WARNING, Whole(ready_ranges))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number of the last block, where no way leads there."""
    for jump in open_ranges(analysis):
        assert jump.target is not None and jump.end is not None and jump.end_span is not None
        (start,), (end,) = labels(analysis, jump.target), labels(analysis, jump.end)
        message = (
            f"from N{shown(jump.target)} the program never comes to N{shown(jump.end)}, so this jump never returns"
        )
        hint = f"; N{shown(jump.end)} stands before N{shown(jump.target)}" if end.line < start.line else ""
        notes = (Note(start.line, start.span, "the range starts here"), Note(end.line, end.span, "and should end here"))
        yield Report(jump.end_span, message + hint, jump.line, notes)
