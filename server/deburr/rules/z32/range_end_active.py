"""Last block of a jump with return that does something.

Whether the control runs block m of GONn-Nm before it returns is not documented; here it does.
An empty block as the end leaves no doubt.

Source: spec/z32.md §6.3

Bad:

    !GON1-N2!
    M30
    N1 G0 X1
    N2 G0 X2
    ^^

Good:

    !GON1-N2!
    M30
    N1 G0 X1
    N2 ;end
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.arithmetic.z32 import shown
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._flow import open_ranges, ready_ranges
from deburr.rules.z32._program import is_active, jumps, labels


@rule(Severity.WARNING, Whole(ready_ranges))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number of the block, once for all jumps."""
    seen = set()
    never = {id(jump) for jump in open_ranges(analysis)}
    for jump in jumps(analysis):
        if id(jump) in never:
            continue
        if jump.end is None or jump.end_span is None or jump.end in seen:
            continue
        seen.add(jump.end)
        for place in labels(analysis, jump.end):
            if is_active(analysis, place.line):
                message = f"block N{shown(jump.end)} ends a range and is run before the return; a control may skip it, use an empty block"
                yield Report(
                    place.span, message, place.line, (Note(jump.line, jump.end_span, "the jump that returns there"),)
                )


def fix(broken: Broken) -> Iterator[Fix]:
    """An empty block with the number behind the block; nothing where a jump goes to the block itself."""
    number, rest = broken.said.strip(), broken.text[broken.span.end :].strip()
    goals = {jump.target for jump in jumps(broken.analysis)}
    is_goal = any(
        place.line == broken.line for each in goals if each is not None for place in labels(broken.analysis, each)
    )
    if rest and None not in goals and not is_goal:
        text = f"{broken.indent}{rest}\n{broken.indent}{number}"
        yield Fix(f"Write `{number}` on a line of its own behind it", (broken.edit(0, len(broken.text), text),))
