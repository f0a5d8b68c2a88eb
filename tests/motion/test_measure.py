"""What stands in a path, worked out by hand."""

import math

import pytest

from deburr.motion import follow
from deburr.motion.measure import Bounds, Measure, measured

SQUARE = """G21 G90 T2 M6
S1000 M3
G0 X30 Y40
G1 Z-10 F100
G3 X30 Y40 I5 J0 F314.159265358979
G4 P1.5
T1 M6
G0 X0 Y0
"""


def measure(text: str, rapid: dict[str, float] | None = None) -> Measure:
    return measured(follow(text.split("\n")), rapid)


def flat(bounds: Bounds) -> list[float]:
    return [value for pair in bounds.values() for value in pair]


def test_lengths_times_and_tools() -> None:
    found = measure(SQUARE, {"X": 3000, "Y": 2400, "Z": 1200})
    # 30 mm at 3000 and 40 mm at 2400 mm/min: Y takes the longer, one second; twice.
    assert (found.moves, found.arcs, found.untimed) == (4, 1, 0)
    assert [found.rapid, found.rapid_seconds] == pytest.approx([100, 2])
    assert [found.cut, found.cut_seconds] == pytest.approx([10 + 10 * math.pi, 12])
    assert [found.dwell_seconds, found.seconds] == pytest.approx([1.5, 15.5])
    assert [(use.number, use.moves) for use in found.tools] == [(2, 3), (1, 1)]
    assert found.tools[0].cut == pytest.approx(10 + 10 * math.pi)
    assert found.tools[1].seconds == pytest.approx(1)


def test_bounds_are_those_of_arcs_and_of_starts() -> None:
    found = measure(SQUARE)
    assert flat(found.cut_bounds) == pytest.approx([30, 40, 35, 45, -10, 0])
    assert flat(found.bounds) == pytest.approx([0, 40, 0, 45, -10, 0])
    assert found.rapid_bounds == {"X": (0, 30), "Y": (0, 40), "Z": (-10, 0)}
    assert measure("G0 X3 A90").rapid_bounds == {"X": (0, 3), "Y": (0, 0), "Z": (0, 0), "A": (0, 90)}
    assert (measure("").bounds, measure("G1 X1 F1").rapid_bounds) == ({}, {})


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("G1 X10 F60", 10),
        ("G20 G1 X1 F1", 60),
        ("G93 G1 X10 F2", 30),
        ("S100 M3 G95 G1 X10 F.1", 60),
        ("G1 A90 F180", 30),
        ("S100 M3 G33 Z-10 K1", 6),
        ("G1 X10", 0),
    ],
)
def test_time_is_as_the_feed_mode_has_it(text: str, seconds: float) -> None:
    found = measure(text)
    assert found.cut_seconds == pytest.approx(seconds)
    assert found.untimed == (seconds == 0)
