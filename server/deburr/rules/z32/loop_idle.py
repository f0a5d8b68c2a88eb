"""Loop that makes one pass only.

The condition of the jump back never holds when the program comes to it, whatever the program is given: the lines of the loop
are run once, as if it were none. Nothing is said of what hangs on a parameter that is only set to numbers
that are written out, because that is a switch.

Source: spec/z32.md §6.2, §6.3

Bad:

    !HA=100!
    N10 G0 X<HA>
    !HA=HA+10; IF HA<100; GON10!
                  ^^^^^^
    M30

Good:

    !HA=0; HB=1!
    N10 G0 X<HA>
    !HA=HA+10; IF HA<100; GON10!
    N20 G0 Y<HB>
    !HC=HC+1; IF HC<HB; GON20!
    M30
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the condition."""
    yield Report(proof.span, proof.message)
