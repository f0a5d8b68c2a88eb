"""Condition that always holds, or compares a variable with itself.

Variables have one value throughout a text, and in a loop one in each pass. Where an outer condition says that |Depth| is greater
than 10, an inner one that asks whether it is greater than 5 decides nothing: its lines would be generated without it, and often
another bound was meant. That it always holds is an info. A variable that is compared with itself is a slip of the
hand, and if that never holds, its lines are never generated. Nothing is said of values that are given for a run, nor of a
condition without variables, because these are switches, nor of conditions in snippets, which other texts use as well. A condition that contradicts those around it has a rule of its own, `if-contradiction`.

Source: spec/metagcode.md §5.3

Bad:

    #IF1 |Depth| greaterthan 10 n
    #IF2 |Depth| greaterthan 5 n
         ^^^^^^^^^^^^^^^^^^^^^
    G1 Z-|Depth|
    #ENDIF2
    #ENDIF1

Bad:

    #IF1 |Mat| equalto Steel a
    #IF2 |Mat| notequalto Brass a
         ^^^^^^^^^^^^^^^^^^^^^^
    S800
    #ENDIF2
    #ENDIF1

Bad:

    #IF1 |Width| notequalto |Width| n
         ^^^^^^^^^^^^^^^^^^^^^^^^^^
    G1 X|Width|
    #ENDIF1

Good:

    #IF1 |Depth| greaterthan 10 n
    #IF2 |Depth| greaterthan 15 n
    G1 Z-|Depth|
    #ENDIF2
    #ENDIF1
    #IF3 1 equalto 0 n
    M0
    #ENDIF3
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the comparison."""
    yield Report(proof.span, proof.message, severity=proof.severity)
