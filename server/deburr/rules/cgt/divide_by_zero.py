"""Division by zero.

It has no value. Reported where the line alone decides the divisor, and where a run meets it; `MOD` divides by the whole part
of its second argument, and 0 to a negative power is a division too.

Source: spec/cgt.md §5.8, §11

Bad:

    #EVAL(#V1=#FEED/0)
                    ^
    #EVAL(#V1=#V2/(2-2))
                  ^^^^^
    #EVAL(#V1=MOD(#V2,0.9))
                      ^^^
    #EVAL(#V1=0^-1)
              ^^^^
    #IF(1+4/-0.0>2)<M08>
            ^^^^

Bad (input=sample.cl):

    #EVAL(#V1=#FEED/(#XPOS-1))
                    ^^^^^^^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #EVAL(#V1=0/4)
    #EVAL(#V1=1/#V2)
    #EVAL(#V1=MOD(#V2,1))
    #EVAL(#V1=0^0)
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.cgt._values import faults
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("quotient", "function", "power")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the divisor."""
    yield from faults(line, node, "divide-by-zero")
