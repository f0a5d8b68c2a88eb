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

from collections.abc import Iterator, Sequence
from functools import cache

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.rule import Note, Report, Severity, Whole, parted, rule
from deburr.rules.z32._program import Jump, Label, jumps, labels, ready_jumps, section_of, sections

_SHOWN = 8
"""Blocks that are shown with a jump; the message counts them all."""


@rule(Severity.ERROR, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the number that is jumped to."""
    found, starts = jumps(analysis), sections(analysis)

    @cache
    def meant_by(target: float, section: int) -> list[Label]:
        places = labels(analysis, target)
        return [place for place in places if section_of(starts, place.line) == section] or places

    def of(some: Sequence[Jump]) -> Iterator[Report]:
        for jump in some:
            meant = meant_by(jump.target, section_of(starts, jump.line)) if jump.target is not None else []
            if jump.target is not None and len(meant) > 1:
                notes = tuple(Note(place.line, place.span, "this block has the number") for place in meant[:_SHOWN])
                message = f"{len(meant)} blocks have the number N{shown(jump.target)}; the control may jump to either"
                yield Report(jump.target_span, message, jump.line, notes)

    yield from parted(found, of)
