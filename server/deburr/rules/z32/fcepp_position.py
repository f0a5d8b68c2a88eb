"""`$FCEPP` behind the first block.

It sets up the emulator before the program starts. Behind the first block it comes too late: that
block already ran without it.

Source: spec/z32.md §6.6

Bad:

    G0 X1
    A=$FCEPP('INIT_VAR_SYST')
    ^^^^^^^^^^^^^^^^^^^^^^^^^

Good:

    A=$FCEPP('INIT_VAR_SYST')
    G0 X1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import first_block, lines
from deburr_grammar.text import Edit, Pos


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the line."""
    first = first_block(analysis)
    for line, node in lines(analysis, "config"):
        if first is not None and first < line:
            config = next(node.find("config"))
            yield Report(
                whole(config),
                "`$FCEPP` sets up what the first block already runs with; move it before that block",
                line,
            )


def fix(broken: Broken) -> Iterator[Fix]:
    """The line before the first block."""
    first = first_block(broken.analysis)
    if first is not None:
        above = Edit(Pos(first, 0), Pos(first, 0), f"{broken.text}\n")
        yield Fix("Move it before the first block", (above, broken.without_line()))
