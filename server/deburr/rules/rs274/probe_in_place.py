"""Probe move to where the tool stands.

G38.2 and G38.4 need a way to go, until the probe is tripped or free again. Where every word of the line
leads to the place where the tool stands already, the control stops with "Start point too close to probe
point". G38.3 and G38.5, which need not meet anything, do nothing there.

The place is known as long as moves, steps, cycles and offsets with literal numbers lead to it.

Source: spec/oracle.md §2

Bad:

    F100
    G0 Z5
    G38.2 Z5
    ^^^^^

Bad:

    F100
    G91
    G38.2 X0 Y0
    ^^^^^

Good:

    F100
    G0 Z5
    G38.2 Z-5
    G91 G38.2 X3
    G38.3 X0
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._moves import LINEAR, MUST_PROBE, Modes, probe_modes
from deburr.rules.rs274._position import Move, Watch, reports
from deburr_grammar.dialects.rs274.modality import AXES


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the probe moves."""
    yield from reports(
        analysis, _WATCH, lambda found: found.first(*(AXES if MUST_PROBE.isdisjoint(found.has) else MUST_PROBE))
    )


def _why(probe: Move) -> str:
    """What is wrong with a probe move, or nothing."""
    ends = [(start, probe.numbers[axis]) for axis, start in zip(LINEAR, probe.start) if axis in probe.numbers]
    if probe.modes.distance == "G91":
        stays = all(step == 0 for _, step in ends)
    else:
        stays = probe.modes.distance == "G90" and all(start == end for start, end in ends)
    return "is a probe move to where the tool stands: it needs a way to go" if ends and stays else ""


def _hangs_on_start(modes: Modes) -> bool:
    return modes.distance != "G91"


_WATCH = Watch("probes", re.compile(r"[Gg][^A-Za-z]*38"), MUST_PROBE, probe_modes, _hangs_on_start, _why)
