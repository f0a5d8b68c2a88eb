"""`&lt` or `&gt` in a program.

The text was pasted from a web page, where `<` is written `&lt` and `>` is written `&gt`. Here they are
read so; the control refuses them.

Source: spec/z32.md §11

Bad:

    HA&ltX+Y>
      ^^^
    !IF HA&gt10; HA=1!
          ^^^

Good:

    HA<X+Y> (as &lt or &gt in a comment)
"""

from collections.abc import Iterator

from deburr.fixers import corrected, safe
from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens


@rule(Severity.WARNING, Text("&[lg]t"))
def check(line: Line) -> Iterator[Report]:
    """Report the entities."""
    for token in tokens(line.node.tree):
        if token.kind in ("LANGLE", "RANGLE") and line.text[token.start] == "&":
            sign = "<" if token.kind == "LANGLE" else ">"
            yield Report(
                Span(token.start, token.end), f"`{line.said(token)}` is read as `{sign}`; the control refuses it"
            )


fix = safe(corrected)
