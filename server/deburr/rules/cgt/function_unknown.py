"""Function that does not exist.

Nothing can be computed with it, so the assignment or the test has no value. Functions are written
in any case.

Source: spec/cgt.md §5.8

Bad:

    #EVAL(#V1=FOO(1))
              ^^^
    #IF(SQRT(#V1)>3)<M08>
        ^^^^

Good:

    #EVAL(#V1=sqr(2)+Abs(#V2))
"""

from collections.abc import Iterator
from difflib import get_close_matches

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.cgt._symbols import functions
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    name = node.children[0]
    said = line.said(name)
    if said.upper() not in functions():
        close = get_close_matches(said.upper(), sorted(functions()), 1, 0.6)
        hint = f"; did you mean `{close[0]}`?" if close else ""
        yield Report(Span(name.start, name.end), f"there is no function `{said}`{hint}")
