"""Number that is still in use by a block around.

An end closes the innermost open block, so a number that stands twice has one meaning. Yet whoever
reads the program, or moves a line of it, takes one block for the other. A number is free again once
its block is closed; `#IF` and `#LOOP` have numbers of their own, and so has every snippet.

Source: spec/metagcode.md §4, §6

Bad:

    #IF1 |a| equalto 1 n
    #IF1 |b| equalto 1 n
    ^^^^
    #ENDIF1
    #ENDIF1

Good:

    #IF1 |a| equalto 1 n
    #LOOP1 |z| 2 c
    #IF01 |b| equalto 1 n
    G1 Z|z|
    #ENDIF01
    #FILE coolant.txt
    #ENDLOOP1
    #ENDIF1
    #IF1 |b| equalto 1 n
    #ENDIF1
    -- Snippets/coolant.txt --
    #IF1 |Coolant| equalto 1 n
    M8
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.blockfix import highest, renumbered
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, gathered, ready, said
from deburr.steps import paced
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.limits import NESTED
from deburr_grammar.structure import Placed


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the inner opener."""
    blocks = gathered(analysis)
    for visit in paced(blocks.visits()):
        if visit is None:
            yield None
            continue
        placed, around = visit
        bracket = placed.bracket
        if bracket.role is not Role.OPEN or bracket.label is None or isinstance(bracket, Foreign):
            continue
        if len(around) > NESTED:
            # Deeper than blocks may be nested, that is what must be mended.
            continue
        outer = next((each for each in reversed(around) if _same(each, placed)), None)
        if outer is not None:
            message = (
                f"`{said(bracket)}` stands inside another `{said(bracket)}`; give the inner block a number of its own"
            )
            yield Report(bracket.span, message, placed.line, (blocks.note(outer),))


def _same(one: Placed, two: Placed) -> bool:
    ours = not isinstance(one.bracket, Foreign)
    return ours and (one.bracket.kind, one.bracket.label) == (two.bracket.kind, two.bracket.label)


def fix(broken: Broken) -> Iterator[Fix]:
    """Give the inner block a number that nothing else has."""
    yield from renumbered(broken, highest(broken, "#(?:IF|LOOP)") + 1)
