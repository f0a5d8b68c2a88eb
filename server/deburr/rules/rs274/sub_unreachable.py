"""Subprogram that is called only where the program never comes.

All its calls stand in branches or loops that are never run, whatever the program is called with, so that it never runs either.
A call under a switch, a parameter that is set at one place only, is none of these.

Source: spec/rs274.md §6

Bad (whole):

    G21 G90 G17 F100
    o<drill> sub
    ^^^^^^^^^^^^
      G0 Z#1
    o<drill> endsub
    #<a>=#5420
    o1 if [#<a> GT 10]
      o2 if [#<a> LT 5]
        (ABORT, too deep)
        o<drill> call [3]
      o2 endif
    o1 endif
    M2

Good:

    o<drill> sub
      G0 Z#1
    o<drill> endsub
    #<drilled>=0
    o1 if [#<drilled> EQ 1]
      o<drill> call [3]
    o1 endif
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the definition."""
    yield Report(proof.span, proof.message)
