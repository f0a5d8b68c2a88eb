"""Condition that always or never holds.

Whatever the program is given, what hangs on the condition is never run, or it decides nothing: one of
the conditions and settings that lead to it is wrong, and they are named. Nothing is said of what hangs on a parameter
that is only set to numbers that are written out, because that is a switch, nor of a condition without parameters, or of one that only
guards against something by a jump to the end of the program. That it always holds is an info.

Source: spec/z32.md §4, §6.2

Bad:

    !HA=PAL[300]!
    !IF HA>10; IF HA<5; HB=1!
                  ^^^^
    G0 X<HB>

Bad:

    !HA=PAL[300]!
    !IF HA<=10; GON20!
    !IF HA<10; HB=1!
        ^^^^^
    N20 G0 X1

Good:

    !HA=0!
    !IF HA=1; GON20!
    G0 Z5
    N20 G0 X1
    !HB=PAL[300]!
    !IF HB>=10; IF HB<50; HC=1!
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the condition."""
    yield Report(proof.span, proof.message, severity=proof.severity)
