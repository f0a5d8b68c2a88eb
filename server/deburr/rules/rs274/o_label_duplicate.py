"""O-word number that is used twice.

Every block of the main program, and every block of one subprogram, needs a number or name of its
own, even if the other block is closed. The control stops with "duplicate O-word label" when it
reaches the second after the first. Where a branch decides whether the first is reached at all,
nothing is reported.

Source: spec/rs274.md §6

Bad:

    #1=0
    o1 if [#1]
    o1 endif
    o1 while [0]
    ^^^^^^^^
    o1 endwhile

Good:

    #1=0
    o1 if [#1]
    o1 endif
    o<drill> sub
      o1 if [#1]
      o1 endif
    o<drill> endsub
    o<drill> call [5]
    o2 while [0]
    o2 endwhile

Good:

    #1=0 #2=1
    o1 if [#1]
      o2 if [#2]
      o2 endif
    o1 else
      o2 if [#2]
      o2 endif
    o1 endif
"""

from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from deburr.blockfix import highest, renumbered
from deburr.blocks import DEEPEST, Block, ready
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import label, note, said

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every block that is only reached when an earlier block with its label has been."""
    for scope in analysis.scopes:
        known: dict[str, list[Block]] = {}
        for block in scope.blocks:
            bracket = block.opener.bracket
            if bracket.label is None:
                continue
            earlier = known.setdefault(bracket.label, [])
            first = next((other for other in islice(earlier, DEEPEST) if _reached_before(other, block)), None)
            if first is None:
                earlier.append(block)
                continue
            message = f"{said(bracket)} uses `{label(bracket)}` a second time; the control refuses it"
            yield Report(bracket.span, message, block.opener.line, (note(first.opener, "has it already"),))


def _reached_before(first: Block, second: Block) -> bool:
    """Whether the second block is only reached when the first has been: it stands in the same branches, or deeper."""
    if first.around is None:
        return True
    same = next((block for block in second.outward() if block.around is first.around), None)
    if same is None:
        return False
    between = first.around.middles[first.before : same.before]
    return not any(placed.bracket.word in ("else", "elseif") for placed in between)


def fix(broken: Broken) -> Iterator[Fix]:
    """Give the block a number that nothing else has."""
    yield from renumbered(broken, highest(broken, r"\bO") + 1)
