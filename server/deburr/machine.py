"""What `[machine]` in `deburr.toml` can say of the machine that runs the programs: its reach, its rates, and how it reads words. Never reads a program."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from deburr_grammar.dialect import Kind, Setting

AXES = "XYZABCUVW"


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _axis(name: str, said: str) -> str:
    return "" if name in tuple(AXES) else f"`{name}` in `{said}` is no axis; these can be: {AXES}"


def _reach(name: str, value: Any) -> str:
    if wrong := _axis(name, "limits"):
        return wrong
    good = isinstance(value, list | tuple) and len(value) == 2 and all(map(_number, value)) and value[0] <= value[1]
    return "" if good else f"`{name}` in `limits` must be the least and the greatest place, as [0, 300]"


def _rate(name: str, value: Any) -> str:
    if wrong := _axis(name, "rapid"):
        return wrong
    return "" if _number(value) and value > 0 else f"`{name}` in `rapid` must be a number above 0"


MACHINE = (
    Setting(
        "limits",
        Kind.TABLE,
        {},
        "how far axes go: least and greatest place in mm (A, B, C: degrees) in the machine's coordinates, as { X = [0, 300] }",
        each=_reach,
    ),
    Setting("z-safe", Kind.NUMBER, None, "the least Z, in mm in the machine's coordinates, to which rapids may go"),
    Setting("spindle", Kind.FLAG, True, "whether cuts need a turning spindle: false for lasers, plotters and the like"),
    Setting("rapid", Kind.TABLE, {}, "rapid rates of axes in mm/min (A, B, C: degrees/min), for times", each=_rate),
    Setting(
        "unit", Kind.CHOICE, "mm", "the unit of lengths where a program says none, and of tool tables", ("mm", "inch")
    ),
    Setting(
        "arc-center",
        Kind.CHOICE,
        "incremental",
        "I, J and K as distances from the start of an arc, or as its centre, where a program does not say it",
        ("incremental", "absolute"),
    ),
    Setting("diameter", Kind.FLAG, False, "whether X is a diameter where a program does not say it"),
    Setting("step", Kind.NUMBER, 1, "what a length without a point counts in units, such as 0.001"),
)


def of_machine(machine: Mapping[str, Any], name: str) -> Any:
    """What is said of it under a key, or the default."""
    setting = next(each for each in MACHINE if each.name == name)
    return machine.get(name, setting.default)
