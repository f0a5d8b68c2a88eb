"""O-word number that is used twice.

Every block of the main program, and every block of one subprogram, needs a number or name of its
own, even if the other block is closed. The control stops with "duplicate O-word label" when it
reaches the second after the first. Where a branch decides whether the first is reached at all,
nothing is reported.

Source: spec/rs274.md §6

Bad:

    o1 if [#1]
    o1 endif
    o1 while [0]
    ^^^^^^^^
    o1 endwhile

Good:

    o1 if [#1]
    o1 endif
    o<drill> sub
      o1 if [#1]
      o1 endif
    o<drill> endsub
    o2 while [0]
    o2 endwhile

Good:

    o1 if [#1]
      o2 if [#2]
      o2 endif
    o1 else
      o2 if [#3]
      o2 endif
    o1 endif
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import Block
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import label, note, said
from deburr_grammar.structure import Placed

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every block that is only reached when an earlier block with its label has been."""
    for scope in analysis.scopes:
        known: dict[str, list[tuple[Placed, frozenset[_Branch]]]] = {}
        for block, around in scope.blocks():
            opener, branches = block.opener, _branches(block, around)
            if opener.bracket.label is None:
                continue
            earlier = known.setdefault(opener.bracket.label, [])
            first = next((placed for placed, others in earlier if others <= branches), None)
            if first is not None:
                message = f"{said(opener.bracket)} uses `{label(opener.bracket)}` a second time; the control refuses it"
                yield Report(opener.bracket.span, message, opener.line, (note(first, "has it already"),))
            earlier.append((opener, branches))


_Branch = tuple[Placed, int]


def _branches(block: Block, around: tuple[Block, ...]) -> frozenset[_Branch]:
    """The branches in which a block stands: each block around it, and how many `else` and `elseif` of that come before."""
    inner = (*around[1:], block)
    return frozenset((outer.opener, _before(outer, part)) for outer, part in zip(around, inner))


def _before(outer: Block, part: Block) -> int:
    before = outer.inner[: next(at for at, each in enumerate(outer.inner) if each is part)]
    return sum(isinstance(each, Placed) and each.bracket.word in ("else", "elseif") for each in before)
