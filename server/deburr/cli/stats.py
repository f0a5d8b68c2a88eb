"""`deburr expand --stats`: what stands in a flat program, for people or as JSON. Never runs one."""

from __future__ import annotations

import json
import sys
from typing import TYPE_CHECKING, Any

from deburr.machine import of_machine
from deburr.motion.measure import RAPID, Bounds, Measure, measured
from deburr.motion.path import Happening, Note

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.cli.flat import Flat
    from deburr.motion import Path

FORMS = ("text", "json")
_DECIMALS = 6
_OFF = 40
"""G40."""


def say(flat: Flat, form: str) -> None:
    """Print it."""
    path = flat.path()
    rapid = of_machine(flat.programs[0].ruleset.machine, "rapid")
    found = measured(path, rapid)
    if form == "json":
        print(json.dumps(data(flat.count, path, found, rapid), indent=2))
    else:
        sys.stdout.write("".join(f"{line}\n" for line in lines(flat.count, path, found, rapid)))


def data(count: int, path: Path, found: Measure, rapid: dict[str, float]) -> dict[str, Any]:
    """The fields: lengths in mm, A, B and C in degrees, times in seconds, rates in mm/min, lines of the flat program from 1 on."""
    times = {"rapid": found.rapid_seconds, "cut": found.cut_seconds, "dwell": found.dwell_seconds}
    return {
        "lines": count,
        "moves": found.moves,
        "arcs": found.arcs,
        "bounds": _bounds(found.bounds),
        "rapid_bounds": _bounds(found.rapid_bounds),
        "cut_bounds": _bounds(found.cut_bounds),
        "length": _rounded({"rapid": found.rapid, "cut": found.cut}),
        "time": _rounded({**times, "total": found.seconds}),
        "untimed": found.untimed,
        "rapid_rates": rapid or {"*": RAPID},
        "tools": [_rounded({"number": use.number, "moves": use.moves, "cut": use.cut, "time": use.seconds}) for use in found.tools],
        "notes": [{"line": note.flat + 1, "message": note.text} for note in _notes(path)],
    }  # fmt: skip


def lines(count: int, path: Path, found: Measure, rapid: dict[str, float]) -> Iterator[str]:
    """The same for people."""
    yield f"lines   {count:,}"
    yield f"moves   {found.moves:,}, arcs among them {found.arcs:,}"
    for axis, (low, high) in found.bounds.items():
        cut = found.cut_bounds.get(axis)
        cuts = f", cuts {_number(cut[0])} to {_number(cut[1])}" if cut is not None else ""
        yield f"{axis}       {_number(low)} to {_number(high)} {'degrees' if axis in 'ABC' else 'mm'}{cuts}"
    yield f"rapid   {_number(found.rapid)} mm in {_clock(found.rapid_seconds)}"
    yield f"cut     {_number(found.cut)} mm in {_clock(found.cut_seconds)}"
    if found.dwell_seconds:
        yield f"dwell   {_clock(found.dwell_seconds)}"
    rates = ", ".join(f"{axis} {rate:,g}" for axis, rate in rapid.items()) or f"{RAPID:,g}"
    yield f"time    {_clock(found.seconds)}, without acceleration; rapids at {rates} mm/min"
    if found.untimed:
        yield f"        {found.untimed:,} cuts have no feed, and count for nothing"
    for use in found.tools:
        name = f"tool {use.number}" if use.number else "no tool"
        yield f"{name}  {use.moves:,} moves, {_number(use.cut)} mm cut, {_clock(use.seconds)}"
    for note in _notes(path):
        yield f"note    line {note.flat + 1}: {note.text}"


def _notes(path: Path) -> list[Note]:
    """What the figures do not show."""
    compensated = (event.flat for event in path.events if event.what is Happening.COMPENSATION and event.value != _OFF)
    first = [
        Note(flat, "cutter compensation is not applied: these are the places that were programmed")
        for flat in compensated
    ][:1]
    return sorted([*path.notes, *first], key=lambda note: note.flat)


def _bounds(bounds: Bounds) -> dict[str, list[float]]:
    return {axis: [_round(low), _round(high)] for axis, (low, high) in bounds.items()}


def _rounded(values: dict[str, float]) -> dict[str, float]:
    return {name: _round(value) for name, value in values.items()}


def _round(value: float) -> float:
    # Adding 0 makes -0 a 0.
    return round(value, _DECIMALS) + 0 if isinstance(value, float) else value


def _number(value: float) -> str:
    return f"{round(value, 3) + 0:,.3f}".rstrip("0").rstrip(".")


def _clock(seconds: float) -> str:
    """Hours, minutes and seconds."""
    whole = round(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}"
