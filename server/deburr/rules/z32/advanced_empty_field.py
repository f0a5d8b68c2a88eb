"""Nothing between two separators of an advanced line.

The control skips an empty field; most often an instruction was lost, or `!` was typed for `;`.

Source: spec/z32.md §3

Bad:

    !X=0;;Y=1!
        ^^
    !;X=0!
    ^^
    !X=0;!
        ^^
    !IF HA>1; GON10! !HA=2!
                   ^^^
    N10 !!
        ^^

Good:

    !X=0;Y=1!
    N10 !IF HA>1; GON10! HA=2!
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._fields import empty_places
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("advanced",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the two separators."""
    for left, right in empty_places(node):
        yield Report(
            Span(left.start, right.end), "there is no instruction between these separators; nothing is done here"
        )


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave a separator out that parts nothing."""
    signs = broken.said.replace(" ", "")
    if signs in ("!;", ";!", ";;"):
        yield broken.replaced(signs.strip(";") or ";", safe=True)
    elif signs == "!!":
        yield broken.deleted(*broken.span) if broken.text.count("!") == 2 else broken.replaced("!")
