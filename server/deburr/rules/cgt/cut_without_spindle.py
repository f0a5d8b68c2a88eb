"""Cut while the spindle does not turn.

In programs for a machine that `[machine]` describes, straight cuts, arcs and threads need M3 or M4
before them, and again behind M5 and M6: a tool that does not turn breaks. The first cut of each such stretch is reported, as
a bounded run comes to it. `spindle = false` says that the machine cuts without one, as lasers and
plotters do.

Source: interface.md, *Configuration*

Bad (input=sample.jsonl, machine.spindle=true):

    G1 X10 F100
    ^^^^^^^^^^^
    G1 X20
    M3 S1000
    G1 X30
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 100}}

Good (input=sample.jsonl, machine.spindle=true):

    M3 S1000
    G1 X10 F100
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 100}}

Good (input=sample.jsonl, machine.spindle=false):

    G1 X10 F100
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 100}}
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.rule import Moved, Severity, rule
from deburr.rules.common._moves import without_spindle

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from deburr.motion import Path
    from deburr.rule import Report


@rule(Severity.WARNING, Moved("spindle", unless_said=True))
def check(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Report the first cut of a stretch."""
    yield from without_spindle(path, machine)
