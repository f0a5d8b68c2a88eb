"""Condition that always or never holds.

Whatever the toolpath is and in whatever order sections are run, what stands in one of its bodies is never output: one of the
conditions and settings that lead to it is wrong, and they are named. Nothing is said of what hangs on a word that gets
one constant only, because that is a switch, nor of a body that only leaves the section. That it always holds is an info.

Source: spec/cgt.md §5.4

Bad:

    #EVAL(#V1=MOD(#TOOL,10))
    #IF(#V1>=10)<M06>
        ^^^^^^^

Bad:

    #EVAL(#S1=M03)
    #IF(#SPEED<0)<#EVAL(#S1=M04)>
    #IFSTR(#S1=M3)<#SPEED>
           ^^^^^^

Good:

    #EVAL(#V9=0)
    #IF(#V9=1)<M00>
    #EVAL(#V1=MOD(#TOOL,10))
    #IF(#V1>=9)<M06>
    #IF(#V1<0)<#EXIT>
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the condition."""
    yield Report(proof.span, proof.message, severity=proof.severity)
