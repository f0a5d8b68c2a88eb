"""Section that is called only where the program never comes.

All its calls stand behind conditions that never hold, whatever the program is given, so that it never runs either. A
call under a switch, a parameter that is only set to numbers that are written out, is none of these.

Source: spec/z32.md §6.4

Bad (whole):

    G0 X0
    !IF ABS(PAL[300])>=0; GON20!
    !GOP1!
    N20 G0 X1
    M30
    :1 probe
    ^^^^^^^^
    G0 Z5
    G26

Good:

    !HA=0!
    !IF HA=1; GOP1!
    M30
    :1 probe
    G0 Z5
    G26
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the line that starts it."""
    yield Report(proof.span, proof.message)
