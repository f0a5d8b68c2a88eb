"""Cut without a feed.

In programs for a machine that `[machine]` describes, G1, G2, G3 and canned cycles need a feed: an F
word on their line or before it. Controls stop there, or go on at the feed of the program before. The
first such cut is reported, as a bounded run comes to it.

Source: interface.md, *Configuration*

Bad (input=sample.jsonl, machine.spindle=true):

    M3 S1000
    G1 X10
    ^^^^^^
    G1 X20
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 0}}

Good (input=sample.jsonl, machine.spindle=true):

    M3 S1000
    G1 X10 F100
    G1 X20
    -- sample.jsonl --
    {"section": "LINE", "set": {"MOV": 0, "XPOS": 0, "YPOS": 0, "ZPOS": 5, "FEED": 0}}
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.rule import Moved, Severity, rule
from deburr.rules.common._moves import without_feed

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from deburr.motion import Path
    from deburr.rule import Report


@rule(Severity.WARNING, Moved("limits", unless_said=True))
def check(path: Path, machine: Mapping[str, Any]) -> Iterator[Report]:
    """Report the first cut without one."""
    yield from without_feed(path, machine)
