"""`$FECPP` for `$FCEPP`.

The heading of the manual spells it so, its examples do not. It is read as `$FCEPP` here; the
emulator may not know it.

Source: spec/z32.md §6.6

Bad:

    A=$FECPP('INIT_VAR_SYST')
      ^^^^^^

Good:

    A=$FCEPP('INIT_VAR_SYST')
"""

from collections.abc import Iterator

from deburr.fixers import corrected, safe
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("config",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    dollar = node.find("DOLLAR")
    if dollar is not None and line.said(dollar).upper() == "$FECPP":
        yield Report(
            Span(dollar.start, dollar.end),
            f"`{line.said(dollar)}` is read as `$FCEPP`; other readers may ignore the line",
        )


fix = safe(corrected)
