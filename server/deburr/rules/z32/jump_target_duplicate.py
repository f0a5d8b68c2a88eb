"""Jump to a block number that several blocks have.

Which of them is meant is open, and the control may take either. A section called as a program
has block numbers of its own, so those of other sections do not count there.

Source: spec/z32.md §6.3, §11

Bad:

    !GON150!
        ^^^
    N150 G0 X1
    N150.0 G0 X2

Good:

    !GON150!
    N150 G0 X1
    N151 G0 X2
    N151 G0 X3
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._program import jumps, labels, section_of, sections
from deburr.rules.z32._values import shown


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number that is jumped to."""
    found, starts = jumps(analysis), sections(analysis)
    for jump in found:
        places = labels(analysis, jump.target) if jump.target is not None else []
        own = [place for place in places if section_of(starts, place.line) == section_of(starts, jump.line)]
        meant = own or places
        if jump.target is not None and len(meant) > 1:
            notes = tuple(Note(place.line, place.span, "this block has the number") for place in meant)
            message = f"{len(meant)} blocks have the number N{shown(jump.target)}; the control may jump to either"
            yield Report(jump.target_span, message, jump.line, notes)
