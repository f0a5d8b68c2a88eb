"""Operation on a value that it does not take.

A root of a negative number, ASIN and ACOS outside -1 to 1, a tangent of 90 degrees, a negative
number to a broken power, a part of a text before its start, and whatever is too large have no
value.

Source: spec/cgt.md §5.8, §7, §11

Bad:

    #EVAL(#V1=SQR(-1))
              ^^^^^^^
    #EVAL(#V1=2*ACOS(1.1))
                ^^^^^^^^^
    #EVAL(#V1=(-8)^0.5)
              ^^^^^^^^
    #EVAL(#V1=TAN(90))
              ^^^^^^^
    #EVAL(#V1=10^400)
              ^^^^^^
    #EVAL(#S1=STRSUB(#S2,0,3))
              ^^^^^^^^^^^^^^^

Bad (input=sample.cl):

    #EVAL(#V1=SQR(#YPOS-4))
              ^^^^^^^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #EVAL(#V1=SQR(0)+ACOS(1)+TAN(89)+(-8)^2)
    #EVAL(#S1=STRSUB(#S2,1,3))
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.cgt._values import faults
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function", "power", "product", "quotient", "sum")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the operation."""
    yield from faults(line, node, "math")
