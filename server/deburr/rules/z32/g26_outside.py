"""G26 in the main program.

G26 ends a subprogram. In the program that the operator starts there is nothing to go back to, and
the control stops. Reported where the main part ends in M2 or M30, so that it is certainly no subprogram.

Source: spec/z32.md §6.4

Bad:

    G0 X1
    G26
    ^^^

Good:

    M30
    :1
    G0 X1
    G26
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import line_deleted
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import is_main, lines, ready_jumps, sections


@rule(Severity.ERROR, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report each G26 before the first section, if this is certainly the main program."""
    starts = sections(analysis)
    found = [(line, node) for line, node in lines(analysis, "G26") if not starts or line < starts[0]]
    if found and is_main(analysis):
        for line, node in found:
            for word in node.find("g_word"):
                if word.children[0].kind == "G26":
                    yield Report(
                        whole(word), "`G26` ends a subprogram; in the main program the control stops here", line
                    )


fix = line_deleted
