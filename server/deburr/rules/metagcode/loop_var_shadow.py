"""Loop over the variable of a loop around it.

Inside a loop its variable has the value of the pass, and an inner loop over the same variable takes
that for its total: with steps to 5, 10 and 15 the inner loop goes down to 5, then from the top to
10, then from the top to 15, so the upper layers are cut again and again. The inner loop may also
stand in a snippet.

Source: spec/metagcode.md §5.4, §6

Bad:

    #LOOP1 |z| 5 c
      #LOOP2 |z| 2 c
             ^^^
        G1 Z-|z|
      #ENDLOOP2
    #ENDLOOP1

Bad:

    #LOOP1 |z| 5 c
      #FILE peck.txt
      ^^^^^^^^^^^^^^
    #ENDLOOP1
    -- Snippets/peck.txt --
    #LOOP1 |z| 2 c
    G1 Z-|z|
    #ENDLOOP1

Good:

    #LOOP1 |y| 10 c
      #LOOP2 |z| 2 c
        G1 Y|y| Z-|z|
      #ENDLOOP2
    #ENDLOOP1
    #LOOP1 |z| 1 c
      G1 Z-|z|
    #ENDLOOP1
"""

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, Gathered, gathered, ready
from deburr.steps import paced
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.forms import counters
from deburr_grammar.dialects.metagcode.limits import NESTED
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.structure import Placed
from deburr_grammar.text import Span


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the variable of each such loop, or the line that brings the loop in."""
    blocks = gathered(analysis)
    for visit in paced(blocks.visits()):
        if visit is None:
            yield None
            continue
        placed, around = visit
        bracket = placed.bracket
        if len(around) > NESTED:
            # Deeper than blocks may be nested, that is what must be mended.
            continue
        if bracket.kind == SNIPPET:
            yield from _brought(blocks, placed, around)
        elif bracket.kind == "loop" and bracket.role is Role.OPEN and not isinstance(bracket, Foreign):
            outers = {name: outer for name in blocks.counts(placed) if (outer := _counting(blocks, name, around))}
            for name, token in counters(analysis.document.node(placed.line)) if outers else ():
                if outer := outers.get(name):
                    yield Report(Span(token.start, token.end), _message(name), placed.line, (blocks.note(outer),))


def _brought(blocks: Gathered, placed: Placed, around: Sequence[Placed]) -> Iterator[Report]:
    effect = blocks.effects[placed.line]
    # Where a snippet closes blocks first, its loops need not stand inside those around it.
    for name, inner in effect.loops.items() if effect is not None and not effect.closers and around else ():
        if outer := _counting(blocks, name, around):
            yield Report(placed.bracket.span, _message(name), placed.line, (inner.note, blocks.note(outer)))


def _counting(blocks: Gathered, name: str, around: Sequence[Placed]) -> Placed | None:
    """The innermost loop that counts a name."""
    return next((outer for outer in reversed(around) if name in blocks.counts(outer)), None)


def _message(name: str) -> str:
    return f"a loop around counts `|{name}|` already; this one divides the value of each pass again"
