"""How a control reads the words of a flat program: what `[machine]` says of it. Reads no file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from deburr.expand.rs274.modes import MM_PER_INCH
from deburr.machine import of_machine

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet


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
    contours: bool = True
    """Whether G70 and G71 are cycles along a contour, as in RS274; where the language names none, they may set inches and millimetres (ISO 6983)."""
    simulate: bool = False
    """Whether what only the machine knows is answered as the stand-alone interpreter does."""


def form_of(ruleset: RuleSet, host: Host, simulate: bool = False) -> Form:
    """How the machine reads that is configured, with the tools and stored parameters of the dialect's settings.

    ``simulate``: as the stand-alone interpreter does, whose own unit is the inch (spec/rs274.md §4).
    """
    from deburr.formats import parameters, tools

    machine = ruleset.machine
    unit = MM_PER_INCH if of_machine(machine, "unit") == "inch" else 1.0
    return Form(
        unit=unit,
        arc_absolute=of_machine(machine, "arc-center") == "absolute",
        diameter=of_machine(machine, "diameter"),
        step=of_machine(machine, "step"),
        tools=tools.read(_text(ruleset, host, "tool-table")).words,
        tool_unit=MM_PER_INCH if simulate else unit,
        stored=parameters.read(_text(ruleset, host, "parameters")).values,
        contours=ruleset.dialect.codes.entry("code", "G70") is not None,
        simulate=simulate,
    )


def _text(ruleset: RuleSet, host: Host, setting: str) -> str:
    path = ruleset.settings.get(setting)
    return (host.read(path) or "") if path else ""
