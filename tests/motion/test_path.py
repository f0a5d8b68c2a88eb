"""Flat programs as moves: points, arcs, offsets and cycles worked out by hand from the reference."""

import math
from itertools import pairwise
from random import Random

import pytest

from deburr.motion import Arc, Event, Happening, Kind, Move, Note, follow
from deburr.motion.arcs import extremes, length, points, sweep
from deburr.motion.form import Form
from deburr.motion.path import Flag, Point

QUARTER = math.pi / 2


def ends(text: str, form: Form | None = None) -> list[tuple[Kind, tuple[float, ...]]]:
    path = follow(text.split("\n"), form)
    return [(move.kind, tuple(round(value, 9) + 0.0 for value in move.end)) for move in path.moves()]


def test_a_move_knows_its_line_feed_and_tool() -> None:
    path = follow(["G21 G90 T3 M6", "S100 M3", "(text) G1 X1 F50", "N5 Y-2.5", "g0 z1 0"])
    assert list(path.moves()) == [
        Move(Kind.FEED, (1.0, 0.0, 0.0), 2, 50.0, 3, Flag.SPINDLE | Flag.SIDEWAYS),
        Move(Kind.FEED, (1.0, -2.5, 0.0), 3, 50.0, 3, Flag.SPINDLE | Flag.SIDEWAYS),
        Move(Kind.RAPID, (1.0, -2.5, 10.0), 4, 50.0, 3, Flag.SPINDLE),
    ]
    assert list(path.events) == [Event(0, 0, Happening.TOOL, 3.0), Event(0, 1, Happening.SPINDLE, 100.0)]
    assert (path.of_line(3), path.before(1), path.tools) == (range(1, 2), (1.0, 0.0, 0.0), (0, 3))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        pytest.param("G20 G1 X1 F1\nG21 X1", [(25.4, 0, 0), (1, 0, 0)], id="units"),
        pytest.param("G91 G0 X1\nX1 Y2\nG90 X1", [(1, 0, 0), (2, 2, 0), (1, 2, 0)], id="steps"),
        pytest.param("G92 X10\nG0 X11\nG92.2\nG0 Y1\nX3", [(1, 0, 0), (1, 1, 0), (3, 1, 0)], id="G92"),
        pytest.param("G10 L2 P2 X5 Y5\nG0 X1\nG55 X1 Y1", [(1, 0, 0), (6, 6, 0)], id="G55"),
        pytest.param("G10 L2 P1 X10 R90\nG0 X2 Y1", [(9, 2, 0)], id="turned system"),
        pytest.param("G0 X1\nG10 L20 P1 X5\nG0 X6", [(1, 0, 0), (2, 0, 0)], id="G10 L20"),
        pytest.param("G52 Z3\nG0 Z1\nG53 G0 Z1", [(0, 0, 4), (0, 0, 1)], id="G52 and G53"),
        pytest.param("G43.1 Z20\nG0 Z5\nG49\nG0 X1", [(0, 0, -20), (0, 0, 5), (0, 0, 25), (1, 0, 25)], id="tool length"),
        pytest.param("G7\nG0 X10 Z1", [(5, 0, 1)], id="diameter"),
        pytest.param("G0 X0 Y1\n@2 ^0", [(0, 1, 0), (2, 0, 0)], id="polar"),
        pytest.param("#1=5 (to be changed)\nG0 Z#1\nX-#1", [(0, 0, 5), (-5, 0, 5)], id="parameters that are left"),
        pytest.param("G1 X1 F1\nM2\nG1 X2", [(1, 0, 0)], id="nothing behind the end"),
    ],
)  # fmt: skip
def test_places(text: str, expected: list[tuple[float, ...]]) -> None:
    assert [end for _, end in ends(text)] == expected


def test_a_canned_cycle_is_its_moves() -> None:
    rapid, feed = Kind.RAPID, Kind.FEED
    assert ends("G0 Z5\nG98 G81 X1 Y2 Z-1 R2 F100\nX3\nG80") == [
        (rapid, (0, 0, 5)),
        (rapid, (1, 2, 5)), (rapid, (1, 2, 2)), (feed, (1, 2, -1)), (rapid, (1, 2, 5)),
        (rapid, (3, 2, 5)), (rapid, (3, 2, 2)), (feed, (3, 2, -1)), (rapid, (3, 2, 5)),
    ]  # fmt: skip
    assert ends("G0 Z5\nG91 G99 G81 X1 Z-3 R-3 L2 F100")[1:] == [
        (rapid, (1, 0, 5)), (rapid, (1, 0, 2)), (feed, (1, 0, -1)), (rapid, (1, 0, 2)),
        (rapid, (2, 0, 2)), (feed, (2, 0, -1)), (rapid, (2, 0, 2)),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "centre", "turns", "angle"),
    [
        ("G2 X1 Y1 I1 J0", (1.0, 0.0), -1, -QUARTER),
        ("G3 X1 Y1 I1 J0", (1.0, 0.0), 1, 3 * QUARTER),
        ("G90.1 G3 X1 Y1 I0 J1", (0.0, 1.0), 1, QUARTER),
        ("G2 X1 Y1 R1", (1.0, 0.0), -1, -QUARTER),
        ("G2 X1 Y1 R-1", (0.0, 1.0), -1, -3 * QUARTER),
        ("G3 X0 Y0 I1 P3", (1.0, 0.0), 3, 12 * QUARTER),
        ("G18 G3 Z2 X0 K1", (1.0, 0.0), 1, 2 * QUARTER),
    ],
)
def test_arcs(text: str, centre: tuple[float, float], turns: int, angle: float) -> None:
    path = follow(["F100", text])
    arc = path.arc(0)
    assert arc is not None
    assert arc.centre == pytest.approx(centre, abs=1e-12)
    assert arc.turns == turns
    assert sweep(arc) == pytest.approx(angle)


HELIX = Arc((1.0, 0.0, 0.0), (0.0, 1.0, 6.0), 17, (0.0, 0.0), 2)


def test_extremes_of_an_arc_are_its_own() -> None:
    assert sum(extremes(HELIX), ()) == pytest.approx((-1, -1, 0, 1, 1, 6))
    quarter = Arc((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 17, (0.0, 0.0), 1)
    assert sum(extremes(quarter), ()) == pytest.approx((0, 0, 0, 1, 1, 0))
    assert length(HELIX) == pytest.approx(math.hypot(5 * QUARTER, 6))


@pytest.mark.parametrize("tolerance", [0.5, 0.01, 0.0001])
def test_chords_stay_near_their_arc(tolerance: float) -> None:
    found: list[Point] = [HELIX.start, *points(HELIX, tolerance)]
    assert found[-1] == HELIX.end
    for (ax, ay, _), (bx, by, _) in pairwise(found):
        assert 1 - math.hypot((ax + bx) / 2, (ay + by) / 2) <= tolerance * 1.000001


def test_what_is_not_understood_is_said_once() -> None:
    path = follow(["%", "O1000", "HELLO WORLD", "G117 X1", "G117 X2 V=3"])
    assert path.notes == (
        Note(2, "`HELLOWORLD` is no word, and is passed over"),
        Note(3, "G117 is not followed"),
        Note(4, "`V=3` is no word, and is passed over"),
    )


def test_a_million_moves_are_held_in_some_sixty_megabytes() -> None:
    path = follow(f"G1 X{at % 97} Y{at % 89}" for at in range(10_000))
    columns = (path.kinds, path.flags, path.x, path.y, path.z, path.flat, path.feeds, path.tool)
    assert sum(column.itemsize for column in columns) <= 60
    assert len(path) == 10_000
    with pytest.raises(TypeError):
        path.x[0] = 1.0


WORDS = (
    "G0",
    "G1",
    "G2",
    "G3",
    "X",
    "Y",
    "Z",
    "I",
    "J",
    "R",
    "F",
    "A",
    "G90",
    "G91",
    "G20",
    "G21",
    "G92",
    "G55",
    "G80",
    "G81",
    "M3",
)


@pytest.mark.parametrize("seed", range(30))
def test_the_short_way_is_the_long_one(seed: int) -> None:
    """Plain lines are read in a way of their own; with a comment they are not plain."""
    random = Random(seed)
    lines = []
    for _ in range(60):
        chosen = dict.fromkeys(random.sample(WORDS, random.randint(1, 5)))
        lines.append(" ".join(word if word[1:] else f"{word}{random.randint(-9, 9) / 2:g}" for word in chosen))
    short, long = follow(lines), follow([f"{line} (x)" for line in lines])
    assert [*short.moves()] == [*long.moves()]
    assert [*short.events] == [*long.events]
    assert [short.arc(index) for index in range(len(short))] == [long.arc(index) for index in range(len(long))]
    assert bytes(short.unknown) == bytes(long.unknown)


@pytest.mark.parametrize(
    ("form", "text", "expected"),
    [
        (Form(unit=25.4), "G0 X1", (25.4, 0, 0)),
        (Form(diameter=True), "G0 X10 Z1\nG8", (5, 0, 1)),
        (Form(step=0.001), "G0 X1000 Y1.5 Z-20", (1, 1.5, -0.02)),
        (Form(tools={1: {"Z": 2.0}}, tool_unit=25.4), "T1 M6\nG43\nG0 Z10\nG53 G0 Z0", (0, 0, -50.8)),
        (Form(stored={5221: 100.0, 5220: 1.0}), "G0 X1\nG53 G0 Y2", (101, 2, 0)),
        (Form(stored={5161: 5.0, 5163: 7.0}), "G28", (5, 0, 7)),
    ],
)
def test_what_differs_from_control_to_control(form: Form, text: str, expected: tuple[float, ...]) -> None:
    assert ends(text, form)[-1][1] == expected


def test_the_centre_of_an_arc_may_be_absolute() -> None:
    path = follow(["G0 X5 Y0", "G3 X0 Y5 I0 J0 F1", "G91.1 X-5 Y0 I0 J-5"], Form(arc_absolute=True))
    found = [arc.centre for index in (1, 2) if (arc := path.arc(index)) is not None]
    assert found == [(0.0, 0.0), (0.0, 0.0)]
