"""Snippets inside snippets, more than 20 deep.

A snippet that the program names is at depth 1, one that it names at depth 2, and 20 is the last.
The whole chain is shown as related places.

Source: spec/metagcode.md §5.1, §6

Bad:

    G0 Z5
    #FILE 1
    ^^^^^^^
    -- Snippets/1 --
    #FILE 2
    -- Snippets/2 --
    #FILE 3
    -- Snippets/3 --
    #FILE 4
    -- Snippets/4 --
    #FILE 5
    -- Snippets/5 --
    #FILE 6
    -- Snippets/6 --
    #FILE 7
    -- Snippets/7 --
    #FILE 8
    -- Snippets/8 --
    #FILE 9
    -- Snippets/9 --
    #FILE 10
    -- Snippets/10 --
    #FILE 11
    -- Snippets/11 --
    #FILE 12
    -- Snippets/12 --
    #FILE 13
    -- Snippets/13 --
    #FILE 14
    -- Snippets/14 --
    #FILE 15
    -- Snippets/15 --
    #FILE 16
    -- Snippets/16 --
    #FILE 17
    -- Snippets/17 --
    #FILE 18
    -- Snippets/18 --
    #FILE 19
    -- Snippets/19 --
    #FILE 20
    -- Snippets/20 --
    #FILE 21
    -- Snippets/21 --
    M9

Good:

    #FILE drill.txt
    -- Snippets/drill.txt --
    #FILE peck.txt
    -- Snippets/peck.txt --
    G83 X0 Y0 Z-5 R2 Q1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered, ready
from deburr_grammar.dialects.metagcode.limits import DEEPEST


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the line with which the chain begins. A circle has no depth and is another rule's."""
    blocks = gathered(analysis)
    for line, bracket in blocks.files:
        path = blocks.library.target(bracket)
        if path is None or path == blocks.library.file or blocks.library.cycle(path):
            continue
        below = blocks.library.longest(path)
        if len(below) >= DEEPEST:
            message = f"`#FILE {bracket.label}` leads more than {DEEPEST} snippets deep, where it ends with an error"
            yield Report(bracket.span, message, line, blocks.library.notes(below))
