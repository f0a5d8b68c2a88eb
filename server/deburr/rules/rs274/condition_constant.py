"""Condition that always or never holds.

Whatever the program is called with, what stands in one of its branches is never run, or the condition
decides nothing: one of the conditions and settings that lead to it is wrong, and they are named. Nothing is said of what hangs
on a parameter that is set at one place only, because that is a switch, nor of a condition without parameters, of
EXISTS, or of a branch that stops the program or leaves a loop or subprogram. That it always holds is an info.

Source: spec/rs274.md §3.2, §6

Bad:

    #<a>=#5420
    o1 if [#<a> GT 10]
      o2 if [#<a> LT 5]
            ^^^^^^^^^^^
        G0 X1
      o2 endif
    o1 endif

Bad:

    #<a>=#5420
    o1 if [[#<a> NE 1] OR [#<a> NE 2]]
          ^^^^^^^^^^^^^^^^^^^^^^^^^^^^
      G0 X1
    o1 else
      G0 X2
    o1 endif

Good:

    #<debug>=0
    o1 if [#<debug> EQ 1]
      G0 X1
    o1 endif
    #<a>=#5420
    o2 if [[#<a> NE 1] AND [#<a> NE 2]]
      G0 X1
    o2 endif
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the condition."""
    yield Report(proof.span, proof.message, severity=proof.severity)
