"""Condition that contradicts those around it.

Variables have one value throughout a text, and in a loop one in each pass. Where an outer condition says
that |Depth| is greater than 10, an inner one that asks whether it is less than 5 never holds, and
its lines are never generated: one of the two is wrong.

Source: spec/metagcode.md §5.3

Bad:

    #IF1 |Depth| greaterthan 10 n
    #IF2 |Depth| lessthan 5 n
         ^^^^^^^^^^^^^^^^^^
    G1 Z-|Depth|
    #ENDIF2
    #ENDIF1

Good:

    #IF1 |Depth| greaterthan 10 n
    #IF2 |Depth| lessthan 50 n
    G1 Z-|Depth|
    #ENDIF2
    #ENDIF1
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the comparison."""
    yield Report(proof.span, proof.message)
