"""Rapid below the safe height.

`[machine] z-safe` is the least Z to which rapids may go, in mm in the machine's coordinates. Reported
are rapids that go down to less, or sideways there, whether the spindle turns or not: they meet clamps
or the part at full speed. To rise straight out of the part is right, and so is what a canned cycle does in its
own hole. Compared is what a bounded run moves; of a height that only the machine
knows, as behind G28, nothing is said.

Source: interface.md, *Configuration*

Bad (input=sample.jsonl, machine.z-safe=2):

    G0 Z5
    G0 X10 Z1
    ^^^^^^^^^
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 100}}

Good (input=sample.jsonl, machine.z-safe=2):

    G0 X10 Z2
    M3 S1000
    G1 Z-3 F100
    G0 Z5
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 100}}
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.rule import Moved, Severity, rule
from deburr.rules.common._moves import too_low

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from deburr.motion import Path
    from deburr.rule import Report


@rule(Severity.WARNING, Moved("z-safe"))
def check(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Report each rapid that goes too low."""
    yield from too_low(path, machine)
