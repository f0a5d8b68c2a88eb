"""Calculation whose result is no finite number.

The control stops with "Calculation resulted in 'infinity'" or "'not a number'". It looks at what brackets
and functions give; inside brackets it compares with an infinite result, or divides by one.

Source: spec/rs274.md §3.2, §3.3

Bad:

    #1=EXP[1000]
       ^^^^^^^^^
    #2=[5 MOD 0]
       ^^^^^^^^^
    #3=[0**-1]
       ^^^^^^^

Good:

    #1=EXP[1]
    #2=[5 MOD 3]
    #3=[0**0]
    #4=[10**400 GT 1]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import faults, literal
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("function", "group"), where=lambda _, node: literal(node)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the function or the brackets."""
    yield from faults(line, node, "not-finite")
