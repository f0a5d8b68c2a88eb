"""`#REPEAT` that makes no pass.

Its count is 0 on every way, whatever the toolpath is: what stands in it is never output. Nothing is said of a count that is
written out, nor of what hangs on a word that gets one constant only, because that is a switch.

Source: spec/cgt.md §5.6

Bad:

    #EVAL(#V1=INT(MOD(#TOOL,3)/3))
    #REPEAT(#V1)<
            ^^^
    X1.0
    >

Good:

    #EVAL(#V1=0)
    #REPEAT(#V1)<
    X1.0
    >
    #REPEAT(0)<X2.0>
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the count."""
    yield Report(proof.span, proof.message)
