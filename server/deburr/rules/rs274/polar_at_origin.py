"""Polar word at the origin, where nothing has an angle.

`@` and `^` are a radius and an angle about the origin of the active system. Where the tool stands at
X0 Y0 there is no angle that could stay: `@` needs a `^` beside it (not in canned cycles), and
under `G91`, where both are changes, neither is possible. The control stops, as with "Must specify
angle in polar coordinate if at the origin".

The tool is known to stand there where a move under `G90` or a `G92` says so in literal numbers, and at
the beginning of the program, as for the control's preview. Steps and other offsets are left alone:
what the control reckons may differ from zero in the last digit.

Source: spec/rs274.md §5

Bad:

    G0 X0 Y0
    G0 @10
       ^^^

Bad:

    G0 X0 Y0
    G91 G0 @10 ^30
           ^^^

Bad:

    F100
    G0 X0 Y0
    G91 G81 @5 Z-1 R1
            ^^

Good:

    G0 X0 Y0
    G0 @10 ^30
    @12
    G91 ^5
    G90 X0 Y0
    F100 G81 @5 Z-1 R1
"""

import re
from collections.abc import Iterator
from itertools import chain

from deburr.analysis import Analysis
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.rs274._moves import Modes, polar_cycle_modes, polar_modes
from deburr.rules.rs274._position import Move, Watch, faults
from deburr.rules.rs274._words import report, said, words

_POLAR = frozenset("@^")


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first polar word of such a line."""
    for fault in chain(faults(analysis, _MOVES), faults(analysis, _CYCLES)):
        if fault is None:
            yield None
            continue
        at, why = fault
        line = Line(analysis.document.node(at), analysis.settings)
        number = words(line).first(*_POLAR)
        yield report(line, number, f"`{said(line, number)}` {why}")._replace(line=at)


def _why(move: Move) -> str:
    """What is wrong with a move by polar words, or nothing."""
    x, y, _ = move.start
    if x != 0 or y != 0:
        return ""
    if move.modes.distance == "G91":
        return "changes a radius or an angle under `G91`, and the tool stands at X0 Y0, where it has none; write both under `G90`"
    return "names no angle, and the tool stands at X0 Y0, where there is none that could stay; write `^`, too"


def _why_cycle(cycle: Move) -> str:
    """The same of a canned cycle: by no way at all it may go."""
    return _why(cycle) if any(cycle.numbers.get(letter) for letter in _POLAR) else ""


def _always(_: Modes) -> bool:
    return True


_SIGN = re.compile("[@^]")
_MOVES = Watch("polar moves", _SIGN, _POLAR, polar_modes, _always, _why, exact=True)
_CYCLES = Watch("polar cycles", _SIGN, _POLAR, polar_cycle_modes, _always, _why_cycle, exact=True)
