"""`break` or `continue` outside its loop.

They name a `while` or `do` loop that is open around them, by its label. For a `repeat` there is no
`break`: the control stops with "no matching while/do label".

Source: spec/rs274.md §6

Bad:

    o1 repeat [3]
      o1 break
      ^^^^^^^^
    o1 endrepeat

Bad:

    o1 while [0]
    o1 endwhile
    o1 continue
    ^^^^^^^^^^^

Good:

    #1=0
    o1 while [#1 LT 3]
      #1=[#1+1]
      o2 if [#1 EQ 2]
        o1 break
      o2 endif
    o1 endwhile
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import Block, outward, ready
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import note, said
from deburr_grammar.structure import Placed

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report | None]:
    """Report every `break` and `continue` whose loop is not around it."""
    for scope in analysis.scopes:
        yield None
        for placed, inside in scope.middles:
            around = tuple(outward(inside)) if placed.bracket.word in ("break", "continue") else ()
            if placed.bracket.word in ("break", "continue") and not any(_is_loop(block, placed) for block in around):
                yield _report(placed, around)


def _report(placed: Placed, around: tuple[Block, ...]) -> Report:
    word = placed.bracket.word
    repeat = next((block.opener for block in around if _same(block, placed)), None)
    if repeat is not None:
        message = f"{said(placed.bracket)} names {said(repeat.bracket)}; only `while` and `do` loops take `{word}`"
        return Report(placed.bracket.span, message, placed.line, (note(repeat),))
    message = f"{said(placed.bracket)} names no `while` or `do` loop that is open around it"
    return Report(placed.bracket.span, message, placed.line)


def _is_loop(block: Block, placed: Placed) -> bool:
    return block.opener.bracket.kind in ("while", "do") and _same(block, placed)


def _same(block: Block, placed: Placed) -> bool:
    labels = {block.opener.bracket.label, placed.bracket.label}
    return len(labels) == 1 or None in labels
