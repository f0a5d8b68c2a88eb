"""Snippet that includes itself.

Directly or by way of others, such a chain has no end, and no `#IF` can stop it: snippets are put in
before conditions are looked at. The chain is shown as related places.

Source: spec/metagcode.md §5.1, §6

Bad:

    #FILE a.txt
    ^^^^^^^^^^^
    -- Snippets/a.txt --
    #FILE a.txt

Bad:

    #IF1 no equalto yes a
    #FILE a.txt
    ^^^^^^^^^^^
    #ENDIF1
    -- Snippets/a.txt --
    #FILE b.txt
    -- Snippets/b.txt --
    #FILE c.txt
    -- Snippets/c.txt --
    #FILE b.txt

Good:

    #FILE a.txt
    #FILE a.txt
    -- Snippets/a.txt --
    #FILE b.txt
    #FILE b.txt
    -- Snippets/b.txt --
    G0 Z5
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the line with which the chain begins."""
    blocks = gathered(analysis)
    for line, bracket in blocks.files:
        path = blocks.library.target(bracket)
        if path is None:
            continue
        if path == blocks.library.file:
            yield Report(
                bracket.span, f"`#FILE {bracket.label}` includes the file in which it stands; this never ends", line
            )
        elif chain := blocks.library.cycle(path):
            again = chain[-1].name
            message = f"`#FILE {bracket.label}` leads to `{again}`, which includes itself; this never ends"
            yield Report(bracket.span, message, line, blocks.library.notes(chain))
