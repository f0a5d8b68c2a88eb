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

from deburr.fixers import did_you_mean
from deburr.formats.machine import FORMAT
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("fmt",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the format or the width."""
    said, *width = (line.said(part) for part in node.children if part.kind == "FORMAT")
    spans = [Span(part.start, part.end) for part in node.children if part.kind == "FORMAT"]
    if not FORMAT.fullmatch(said):
        yield Report(spans[0], f"`{said}` is no format such as `D3.4`{_hint(said, width)}")
    elif width and not re.fullmatch("[0-9]+", width[0]):
        yield Report(spans[1], f"`{width[0]}` is no width; a whole number is needed")


def _hint(said: str, width: list[str]) -> str:
    """What was meant, or which part is missing."""
    tried = (said.upper(), f"{said}.{width[0]}" if width else "", f"{said}.0")
    if (found := next((each for each in tried if FORMAT.fullmatch(each)), None)) is not None:
        return f"; did you mean `{found}`?"
    if not re.match("[DFTLPZE]", said):
        return "; its first letter is one of D F T L P Z E"
    return "; digits must stand on both sides of the point"


fix = did_you_mean
