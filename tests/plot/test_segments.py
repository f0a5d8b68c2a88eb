"""Which segments are drawn when there are too many, and how far the others lie from them."""

from math import dist

from deburr.motion.measure import measured
from deburr.plot.extent import Extent, reach
from deburr.plot.segments import drawn
from support.plots import path_of, rows


def away(point, segment) -> float:
    """How far a point is from a straight segment."""
    start, end = segment
    way = [b - a for a, b in zip(start, end)]
    square = sum(each * each for each in way)
    part = sum((p - a) * w for p, a, w in zip(point, start, way)) / square if square else 0.0
    part = min(1.0, max(0.0, part))
    return dist(point, [a + part * w for a, w in zip(start, way)])


def test_all_are_drawn_as_long_as_they_are_few():
    path = path_of("G21 G90 F100\nG0 X10\nG2 X20 Y10 J10\nG1 X0\nM2")
    found = drawn(path, reach(path).all)
    assert (len(found.segments), found.total, found.tolerance) == (3, 3, 0.0)
    assert [segment.arc is not None for segment in found.segments] == [False, True, False]


def test_what_is_left_out_lies_within_the_stated_tolerance():
    path = path_of(rows(4_000))
    found = drawn(path, reach(path).all, most=300)
    assert len(found.segments) <= 300 < found.total
    lines = [(segment.start, segment.end) for segment in found.segments]
    for index in range(0, len(path), 37):
        ends = path.before(index), path[index].end
        middle = tuple(sum(pair) / 2 for pair in zip(*ends))
        for point in (*ends, middle):
            assert min(away(point, line) for line in lines) <= found.tolerance


def test_arcs_count_as_their_chords():
    arcs = "\n".join(f"G2 X{index + 1} Y0 I0.5" for index in range(400))
    path = path_of(f"G21 G90 F100\nG0 X0 Y0\n{arcs}\nM2")
    found = drawn(path, reach(path).all, most=100)
    assert len(found.segments) <= 100
    top = path.before(200)[0] + 0.5, 0.5, 0.0
    assert min(away(top, (segment.start, segment.end)) for segment in found.segments) <= found.tolerance


def test_the_extent_holds_what_arcs_swing_out_to():
    found = reach(path_of("G21 G90 F100\nG0 X10 Y0 Z2\nG3 X-10 Y0 I-10\nG1 Z-1\nM2"))
    # The start at zero is part of the rapid; the half circle reaches Y 10 between its ends.
    assert found.all == Extent((-10.0, 0.0, -1.0), (10.0, 10.0, 2.0))
    assert found.cuts == Extent((-10.0, 0.0, -1.0), (10.0, 10.0, 2.0))


def test_the_extent_is_what_is_measured():
    """It is worked out in slices, for an editor that waits; the figures of `--stats` come from elsewhere."""
    path = path_of(
        "G20 G90 G18 F10\nT1 M6\nG0 X1 Z2\nG2 X3 Z2 I1\nG17 G3 X3 Y4 Z-1 J2\nG43.1 Z1\nG81 X5 Z-2 R1\nX6\nG80\nM2"
    )
    bounds, found = measured(path), reach(path)
    for expected, extent in ((bounds.bounds, found.all), (bounds.cut_bounds, found.cuts)):
        assert extent is not None
        assert dict(zip("XYZ", zip(extent.low, extent.high))) == {axis: expected[axis] for axis in "XYZ"}


def test_of_nothing_there_is_no_extent():
    assert reach(path_of("G21\nM2")) == (None, None)
