"""Message that the control never shows.

Of several comments on a line only the last one acts, and on a line with an O-word none does: the
others are passed over without a word. A `;` comment does not count.

Source: spec/rs274.md §1.4; spec/oracle.md §3

Bad:

    (MSG,change tool)(T4, 10 mm)
    ^^^^^^^^^^^^^^^^^
    (DEBUG, x #5420) G0 X1 (PRINT, y #5421)
    ^^^^^^^^^^^^^^^^

Bad:

    #1=1
    o1 if [#1 EQ 1] (MSG,wrong side)
                    ^^^^^^^^^^^^^^^^
    o1 endif

Good:

    (T4, 10 mm)(MSG,change tool)
    (MSG,change tool) ; T4, 10 mm
    #1=1
    o1 if [#1 EQ 1] (wrong side)
      (MSG,wrong side)
    o1 endif
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import moved_above
from deburr.rule import Line, Report, Severity, Text, rule
from deburr.rules.rs274._comments import ACTIVE, active, comments
from deburr_grammar.text import Span


@rule(Severity.WARNING, Text(ACTIVE, signs="("))
def check(line: Line) -> Iterator[Report]:
    """Report every active comment that is not the last, or stands beside an O-word."""
    found = comments(line)
    beside = "o_line" in line.node.kinds
    why = "comments beside an O-word do nothing" if beside else "only the last comment on a line does anything"
    for comment in found if beside else found[:-1]:
        if word := active(line, comment):
            message = f"this `{word}` is passed over: {why}; give it a line of its own"
            yield Report(Span(comment.start, comment.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Give it a line of its own: behind an O-word, before everything else."""
    if "beside an O-word" not in broken.finding.message:
        yield from moved_above(broken)
        return
    out, end = broken.deleted(*broken.span).edits[0], len(broken.text)
    yield Fix("Write it on the next line", (out, broken.edit(end, end, f"\n{broken.indent}{broken.said}")))
