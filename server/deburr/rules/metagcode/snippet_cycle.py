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

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered, ready
from deburr.rules.metagcode._library import Library, Link


@rule(Severity.ERROR, Whole(ready))
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
            message = f"`#FILE {bracket.label}` leads to {_circle(blocks.library, chain)}; this never ends"
            yield Report(bracket.span, message, line, blocks.library.notes(chain))


def _circle(library: Library, chain: Sequence[Link]) -> str:
    """What includes itself, and by way of which others."""
    again = chain[-1].name
    found = library.find(again)
    first = next((at for at, link in enumerate(chain) if found is not None and link.file == found.path), 0)
    others = [f"`{link.name}`" for link in chain[first:-1]]
    way = f" by way of {', '.join(others)}" if others else ""
    return f"`{again}`, which includes itself{way}"
