"""Text behind a command that leaves the section.

`#EXIT`, `#EXITC` and `#GOTO` do not come back, so what stands behind them in the same body is
never output.

Source: spec/cgt.md §5.5, §7

Bad:

    #EXIT M08
         ^^^^

Bad:

    #IF(#V9=1)<#GOTO(END)M09>
                         ^^^

Bad:

    #EXIT
    <X#XPOS>
    ^

Good:

    #IF(#V9=1)<M09 #EXIT>
    M08
    #EXIT // done
"""

from collections.abc import Iterator
from itertools import chain

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Body, Item


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first thing behind the command."""
    yield from parted(template_of(analysis).bodies, lambda bodies: chain.from_iterable(map(_in, bodies)))


def _in(body: Body) -> Iterator[Report]:
    left: Item | None = None
    for part in body.parts:
        item = part if isinstance(part, Item) else part.opener
        assert item is not None
        if left is not None and not item.blank and item.kind != "comment":
            note = Note(left.line, left.span, "the section is left here")
            yield Report(
                item.span,
                f"`{item.text.strip()}` is never reached; `{left.text}` leaves the section before it",
                item.line,
                (note,),
            )
            return
        if item.kind == "exit" or (item.kind == "call" and item.name == "GOTO"):
            left = item
