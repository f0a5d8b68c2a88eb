"""Circles as they are seen from four sides."""

from math import sqrt

import pytest

from deburr.motion import Arc
from deburr.plot.views import FRONT, ISOMETRIC, SIDE, TOP, ellipse


def whole(plane: int, turns: int = 1, rise: float = 0.0) -> Arc:
    """A circle of radius 10 about the origin of its plane."""
    start = {17: (10.0, 0.0, 0.0), 18: (0.0, 0.0, 10.0), 19: (0.0, 10.0, 0.0)}[plane]
    across = {17: 2, 18: 1, 19: 0}[plane]
    end = tuple(value + (rise if axis == across else 0.0) for axis, value in enumerate(start))
    return Arc(start, (end[0], end[1], end[2]), plane, (0.0, 0.0), turns)


@pytest.mark.parametrize("plane", [17, 18, 19])
def test_a_circle_looks_the_same_in_each_plane_of_an_isometric_view(plane):
    seen = ellipse(whole(plane), ISOMETRIC)
    # All three axes are foreshortened alike, so each circle keeps its radius along one way and has a third of its square across it.
    assert (seen.first, seen.second) == (pytest.approx(10), pytest.approx(10 / sqrt(3)))


def test_the_long_axis_of_an_isometric_circle_lies_across_the_axis_of_its_plane():
    assert ellipse(whole(17), ISOMETRIC).turned % 180 == pytest.approx(0, abs=1e-6)
    # From the right and in front X goes down to the right by 30 degrees: a circle about X is widest across that, at 60.
    assert ellipse(whole(19), ISOMETRIC).turned % 180 == pytest.approx(60)
    assert ellipse(whole(18), ISOMETRIC).turned % 180 == pytest.approx(120)


@pytest.mark.parametrize(("plane", "view", "same"), [(17, TOP, True), (18, FRONT, False), (19, SIDE, True)])
def test_a_circle_is_one_from_along_its_axis(plane, view, same):
    # Plane 18 turns from Z to X, which is clockwise for who looks along Y with X to the right and Z up.
    seen = ellipse(whole(plane), view)
    assert (seen.first, seen.second, seen.same) == (pytest.approx(10), pytest.approx(10), same)


@pytest.mark.parametrize(("plane", "view"), [(17, FRONT), (17, SIDE), (18, TOP), (18, SIDE), (19, TOP), (19, FRONT)])
def test_edge_on_it_is_none(plane, view):
    assert ellipse(whole(plane), view) is None


def test_a_helix_is_one_from_above_only():
    helix = whole(17, 3, -5.0)
    assert ellipse(helix, TOP) is not None
    assert ellipse(helix, ISOMETRIC) is None


def test_a_spiral_is_none():
    assert ellipse(Arc((10.0, 0.0, 0.0), (0.0, 12.0, 0.0), 17, (0.0, 0.0), 1), TOP) is None
