"""Move outside of the machine's limits.

`[machine] limits` says how far axes go, as `limits = { X = [0, 300] }`: mm (A, B and C: degrees) in the
machine's coordinates. A control stops there, in the middle of the part. Compared is what a bounded run
moves, arcs with all places that they pass. Work offsets, G92 and tool lengths count as far as the
program, its stored parameters and the tool table tell them; others count as zero, which the message says, so
give them where the part's zero is not the machine's. Where a language does not name `G70` and `G71`, they may set
inches and millimetres: behind the one that changes the unit no length is held against limits, and `deburr check -v` says so. Of a place that only the machine knows, as behind G28, nothing is said;
where G53 goes is always known.

Source: interface.md, *Configuration*

Bad (machine.limits={ X = [0, 300] }):

    G0 X300
    G0 X300.5
    ^^^^^^^^^

Bad (machine.limits={ Y = [-10, 10] }):

    M3 S1000
    G2 X20 Y0 I10 J0 F100
    G2 X50 Y0 I15 J0
    ^^^^^^^^^^^^^^^^

Good (machine.limits={ X = [0, 300] }):

    G0 X300
    G0 X0
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.rule import Moved, Severity, rule
from deburr.rules.common._moves import outside

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from deburr.motion import Path
    from deburr.rule import Report


@rule(Severity.ERROR, Moved("limits"))
def check(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Report each move that goes too far."""
    yield from outside(path, machine)
