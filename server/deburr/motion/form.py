"""How a control reads the words of a flat program: what `[machine]` says of it. Reads no file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Form:
    """What differs from control to control."""

    unit: float = 1.0
    """Millimetres in the unit that holds at the start: 1, or 25.4 where a program starts in inches."""
    arc_absolute: bool = False
    """Whether I, J, K are the centre itself, not its distance from the start, until G90.1 or G91.1 says so."""
    diameter: bool = False
    """Whether X is a diameter until G7 or G8 says so."""
    step: float = 1.0
    """What a length without a point counts in units: 0.001 where `X1000` is 1."""
    tools: Mapping[int, Mapping[str, float]] = field(default_factory=dict)
    """Tool lengths along the axes by tool and axis, in ``tool_unit``."""
    tool_unit: float = 1.0
    """Millimetres in the unit of ``tools`` and ``stored``."""
    stored: Mapping[int, float] = field(default_factory=dict)
    """Stored parameters by number: offsets of work systems (5221 and up), G92 (5210), homes (5161, 5181); none: not known."""
    simulate: bool = False
    """Whether what only the machine knows is answered as the stand-alone interpreter does."""
