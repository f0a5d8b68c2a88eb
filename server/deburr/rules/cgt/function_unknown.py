"""Function that does not exist.

Nothing can be computed with it, so the assignment or the test has no value. Functions are written
in any case.

Source: spec/cgt.md §5.8

Bad:

    #EVAL(#V1=ROUND(#XPOS))
              ^^^^^
    #IF(SQRT(#V1)>3)<M08>
        ^^^^

Good:

    #EVAL(#V1=RND(#XPOS,3))
    #EVAL(#V1=sqr(2)+Abs(#V2))
"""

from collections.abc import Iterator

from deburr.fixers import did_you_mean
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.templates.symbols import functions, nearest
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    name = node.children[0]
    said = line.said(name)
    if said.upper() not in functions():
        close = nearest(said, functions())
        hint = f"; did you mean `{close}`?" if close else ""
        yield Report(Span(name.start, name.end), f"there is no function `{said}`{hint}")


fix = did_you_mean
