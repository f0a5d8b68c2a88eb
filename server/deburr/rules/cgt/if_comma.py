"""Joined tests without the comma.

The comma in front of `#AND` and `#OR` separates the tests of an `#IF`. Without it the generator
may take the operator for a part of the value before it.

Source: spec/cgt.md §5.4

Bad:

    #IF(#V2>3#OR#V2<-1)<M08>
             ^^^
    #IFSTR(#S1=G00#AND#S2=G01,#OR#S3=)<M08>
                  ^^^^

Good:

    #IF(#V2>3,#OR#V2<-1)<OUT>#ELSE<IN>
    #IF(#V2>3 , #AND #V2<5)<M08>
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("tests", "string_tests")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the operator."""
    for before, part in zip(node.children, node.children[1:]):
        if part.kind == "LOGIC" and before.kind != "COMMA":
            said = line.said(part)
            yield Report(Span(part.start, part.end), f"the comma before `{said}` is missing; write `,{said}`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the comma."""
    yield broken.inserted(broken.span.start, ",")
