"""Number format that does not exist.

A format is one of the letters D F T L P Z E, an optional `+` or `!`, and the digits before and
behind the point: `D3.4`. A second value is the width.

Source: spec/cgt.md §3, §5.1

Bad:

    #FMT(#XPOS, Q3.4)
                ^^^^
    #FMT(#XPOS,D3)
               ^^
    #FMT(#XPOS,d3.4)
               ^^^^
    #FMT(#XPOS,D-3.4)
               ^^^^^
    #FMT(#XPOS,D3.4,wide)
                    ^^^^

Good:

    #FMT(#XPOS, D3.4)
    #FMT(#F_Decimal,P!3.4,10)
    #FMT(#YPOS,E+3.4)
"""

import re
from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_FORMAT = re.compile(r"[DFTLPZE][+!]?[0-9]+\.[0-9]+")


@rule(Severity.ERROR, Nodes(("fmt",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the format or the width."""
    said, *width = (part for part in node.children if part.kind == "FORMAT")
    if not _FORMAT.fullmatch(line.said(said)):
        close = _FORMAT.fullmatch(line.said(said).upper())
        hint = f"; did you mean `{close[0]}`?" if close else ""
        yield Report(Span(said.start, said.end), f"`{line.said(said)}` is no format such as `D3.4`{hint}")
    for part in width:
        if not re.fullmatch("[0-9]+", line.said(part)):
            yield Report(Span(part.start, part.end), f"`{line.said(part)}` is no width; a whole number is needed")
