"""Arc that cannot be: its centre or radius does not fit its ends.

The centre must be as far from the start of an arc as from its end: to 0.0282 mm (0.0028 inch), or to 0.1 %
of the radius in a large arc, up to 2.8 mm (0.28 inch). A radius R must reach from start to end to 0.00127 mm
(0.00005 inch), the ends must not be one point, and no radius may be zero. The control stops, as with
"Radius to end of arc differs from radius to start".

The start is known as long as moves, steps, cycles and offsets with literal numbers lead to it. Work systems and their rotation
(`G10` with L2 and L20, `G54` to `G59.3`), `G92`, `G52` and tool offsets (`G43.1`, `G49`) count as far as the program or the stored
parameters (`parameters`) tell both what was in force and what comes; a length that is stored is certain only where `[machine]` says
in which `unit`. What only the machine knows (offsets that were stored and not given, where a probe stops, home) leaves the start
unknown until the next absolute move. At the beginning of the program it is taken for X0 Y0 Z0, as the control's preview does: an
arc from wherever the machine happens to stand is none that anyone could mean.

Under `G7` the word X is a diameter, here as in the offsets of `G92` and `G10`; I and R never are.

Source: spec/rs274.md §8, §10

Bad:

    F100
    G0 X0 Y0
    G2 X1 Y1 I0.3 J1
    ^^

Bad:

    F100
    G2 X10 I4
    ^^

Bad:

    F100
    G0 X5 Y5
    G3 X10 R1
    ^^

Bad:

    F100
    G0 X1 Y1
    G2 X1 Y1 R1
    ^^

Bad:

    F100
    G2 X1 I0 J0
    ^^

Bad:

    F100 G91
    G2 X2 I1
    X2 I3
    ^^

Bad:

    F100
    G18 G0 X0 Z0
    G2 X2 Z2 K0.5
    ^^

Bad:

    F100
    G91 G0 X5
    G90 G2 X10 I4
        ^^

Bad:

    F100
    G0 X25.4
    G20
    G2 X2 I0.3
    ^^

Bad:

    F100
    G7 G18 G0 X20 Z0
    G2 X10 Z-5 I-10 K0
    ^^

Bad:

    F100
    G52 X0 Y0
    G0 X10 Y0
    G52 X10
    G2 X10 I4
    ^^

Good:

    F100
    G52 X0 Y0
    G0 X10 Y0
    G52 X10
    G2 X10 I5

Good:

    F100
    G0 X0 Y0
    G2 X1 Y1 I0 J1
    G3 X2.001 Y1 R0.5
    G2 I1

Good:

    F100
    G7 G18 G0 X20 Z0
    G2 X10 Z-5 I-5 K0
    G8 G3 X10 Z0 K5
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from math import hypot
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._moves import Modes, arc_modes
from deburr.rules.rs274._position import Move, Watch, reports
from deburr.rules.rs274._words import ARCS
from deburr_grammar.dialects.rs274.modality import AXES


class _Limits(NamedTuple):
    """How far two radii may differ, at least and at most; how far R may be too short; what is no radius."""

    near: float
    far: float
    short: float
    zero: float


_RELATIVE = 0.001
_LIMITS = {
    "G21": _Limits(0.02 * 2**0.5, 2 * 2**0.5, 0.00127, 0.00127),
    "G20": _Limits(0.002 * 2**0.5, 0.2 * 2**0.5, 0.00005, 0.00005),
}
_UNKNOWN = _Limits(0.02 * 2**0.5, 2 * 2**0.5, 0.00127, 0.00005)
"""Where the units are not known: what is wrong in both."""
_ROUNDING = 1e-6
"""What exceeds a limit by a smaller part of it may do so by rounding."""


class _Plan(NamedTuple):
    """How the arcs of some modes are read: where their axes stand in a position, the letters of axes and centre, whether these are steps, the limits."""

    places: tuple[int, int]
    axes: tuple[str, str]
    centre: tuple[str, str]
    steps: bool
    centre_steps: bool
    limits: _Limits


_PLANES = {"G17": ((0, 1), "XY", "IJ"), "G18": ((0, 2), "XZ", "IK"), "G19": ((1, 2), "YZ", "JK")}
_CENTRES = frozenset("IJK")
_DIAMETER = "; under `G7` X is a diameter, and I and R are none"


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the arcs."""
    yield from reports(
        analysis, _WATCH, lambda found: found.first(*(AXES | _CENTRES if ARCS.isdisjoint(found.has) else ARCS))
    )


def _why(arc: Move) -> str:
    """What is wrong with an arc, or nothing."""
    plan, numbers = _plan(arc.modes), arc.numbers
    if plan is None:
        return ""
    here = [arc.start[at] for at in plan.places]
    end = [_way(from_, numbers.get(axis), plan.steps) for from_, axis in zip(here, plan.axes)]
    given = _CENTRES.intersection(numbers)
    if "R" in numbers:
        # Without a word for its end, and with a centre, other rules speak.
        ended = not given and (plan.axes[0] in numbers or plan.axes[1] in numbers)
        return _said_of(arc, _of_radius(abs(numbers["R"]), end, plan.limits)) if ended else ""
    if not given or not (given <= set(plan.centre)) or not (plan.centre_steps or len(given) == len(plan.centre)):
        return ""
    offset = [_way(from_, numbers.get(letter), plan.centre_steps) for from_, letter in zip(here, plan.centre)]
    return _said_of(arc, _of_centre(offset, end, plan.limits))


def _said_of(arc: Move, why: str) -> str:
    """What is wrong, and under `G7` what its words mean, since many take I for a diameter, too."""
    return why + _DIAMETER if why and arc.modes.share != 1 else why


def _hangs_on_start(modes: Modes) -> bool:
    return not (modes.distance == "G91" and modes.centre == "G91.1")


_WATCH = Watch(
    "arcs",
    re.compile(r"[IJKRijkr]|[Gg][^A-Za-z]*[23]"),
    ARCS | {"I", "J", "K", "R"},
    arc_modes,
    _hangs_on_start,
    _why,
)


@cache
def _plan(modes: Modes) -> _Plan | None:
    if modes.plane not in _PLANES or modes.distance not in ("G90", "G91") or modes.centre not in ("G90.1", "G91.1"):
        return None
    places, axes, centre = _PLANES[modes.plane]
    limits = _LIMITS.get(modes.units or "", _UNKNOWN)
    steps, centre_steps = modes.distance == "G91", modes.centre == "G91.1"
    return _Plan(places, (axes[0], axes[1]), (centre[0], centre[1]), steps, centre_steps, limits)


def _way(here: float | None, to: float | None, step: bool) -> float | None:
    """From the start along an axis; without a word it stays where it is. None: not known."""
    if to is None:
        return 0.0
    return to if step else None if here is None else to - here


def _of_centre(offset: list[float | None], end: list[float | None], limits: _Limits) -> str:
    (i, j), (x, y) = offset, end
    if i is None or j is None:
        return ""
    first = last = hypot(i, j)
    if x is not None and y is not None:
        last = hypot(i - x, j - y)
    apart = abs(first - last)
    if apart <= limits.near and first > limits.zero and last > limits.zero:
        return ""
    if min(first, last) < limits.zero * (1 - _ROUNDING):
        return f"is an arc whose centre is its {'start' if first <= last else 'end'}: it has no radius"
    far, near = (apart > limit * (1 + _ROUNDING) for limit in (limits.far, limits.near))
    if far or (near and apart > _RELATIVE * max(first, last) * (1 + _ROUNDING)):
        return f"is an arc whose centre lies {_said(first)} from its start and {_said(last)} from its end; the two must be equal"
    return ""


def _of_radius(radius: float, end: list[float | None], limits: _Limits) -> str:
    x, y = end
    if x is None or y is None:
        return ""
    if x == y == 0:
        return "is an arc of radius R that ends where it starts: its centre could be anywhere; write I, J or K"
    half = hypot(x, y) / 2
    if half - radius > limits.short * (1 + _ROUNDING):
        return f"is an arc of radius {_said(radius)} to a point {_said(2 * half)} away; the radius must be {_said(half)} at least"
    return ""


def _said(length: float) -> str:
    return f"{length:.4f}".rstrip("0").rstrip(".")
