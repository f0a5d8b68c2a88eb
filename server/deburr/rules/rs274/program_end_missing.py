"""Program without an end.

A program ends with M2 or M30, or lies between two lines with `%`. Without them the control stops
at the end of the file with "File ended with no percent sign or program end". Nothing is said where
an M2 stands in a block or in another file, so that the run decides. Of a file that is not meant to
be started it is only noted: one that only defines subprograms, and a piece that ngcgui puts before
or behind others, which says `(not_a_subfile)`. An empty file is no program yet.

Source: spec/rs274.md §1.1

Bad (whole):

    G21 G90
    G0 X10
    ^^^^^^

Bad (whole):

    o<drill> call
    M5 (spindle off)
    ^^^^^^^^^^^^^^^^
    -- drill.ngc --
    o<drill> sub
      G0 X10
    o<drill> endsub

Bad (whole):

    o<drill> sub
      G0 X10
      M2
    o<drill> endsub
    ^^^^^^^^^^^^^^^

Bad (whole):

    (not_a_subfile)
    G21 G90
    ^^^^^^^

Good (whole):

    G0 X10
    M30

Good (whole):

    #1=2
    o1 if [#1 GT 0]
      M2
    o1 endif

Good (whole):

    o<drill> sub
      M2
    o<drill> endsub
    o<drill> call

Good (whole):

    o<finish> call
    -- finish.ngc --
    o<finish> sub
      M5
      M2
    o<finish> endsub
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import appended
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._frame import ends, is_part, last_line, may_end, percents

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report the last line. Of programs with a percent sign the rule on these speaks."""
    last = last_line(analysis)
    if last is None or ends(analysis) or percents(analysis):
        return
    if is_part(analysis):
        # Where a sub is not closed, an M2 behind it seems to be its own.
        if not analysis.document.faults:
            message = "this file is no program of its own; started as one, it would need M2 or M30"
            yield Report(last.span, message, last.line, severity=Severity.INFO)
    elif not may_end(analysis):
        yield Report(last.span, "the program ends without M2, M30 or `%`; the control stops here", last.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """End the program behind its last line."""
    if "the program ends without" in broken.finding.message:
        yield appended(broken, "M2")
