"""The SVG picture: its curves, and that each example's picture is the one that was looked at."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from deburr.motion import Note
from deburr.plot.svg import picture
from support.plots import path_of, rows

GOLDEN = Path(__file__).parent / "golden"
HEAD = "G21 G90 G17 F100\nG0 X0 Y0 Z0\n"


def curves(text: str, view: str, kind: str = "cut") -> list[str]:
    """The data of the paths of a kind in a view."""
    root = ElementTree.fromstring(picture("part", path_of(text))[0])
    space = "{http://www.w3.org/2000/svg}"
    (group,) = (each for each in root.iter(f"{space}g") if each.get("id") == view)
    return [each.get("d", "") for each in group if each.get("class") == kind]


def sweeps(data: str) -> set[str]:
    return set(re.findall(r"A\S+ \S+ \S+ 0 ([01]) ", data))


def test_an_arc_is_an_arc_and_clockwise_is_clockwise():
    # SVG's flag is 1 for the way in which angles grow where y goes down: clockwise.
    (clockwise,) = curves(f"{HEAD}G2 X10 Y-10 J-10\nM2", "top")
    (counter,) = curves(f"{HEAD}G3 X10 Y10 J10\nM2", "top")
    assert (sweeps(clockwise), sweeps(counter)) == ({"1"}, {"0"})
    assert "L" not in clockwise + counter


def test_the_picture_of_an_arc_has_the_radius_of_its_scale():
    (data,) = curves(f"{HEAD}G3 X0 Y20 J10\nG3 X0 Y0 J-10\nM2", "top")
    radii = {radius for pair in re.findall(r"A(\S+) (\S+) ", data) for radius in pair}
    numbers = [tuple(map(float, pair)) for pair in re.findall(r"[ML ](-?[\d.]+) (-?[\d.]+)(?=[A-Z]|$)", data)]
    ys = [y for _, y in numbers]
    # From the lowest point of the circle to the highest are 20 mm, twice the radius.
    assert len(radii) == 1
    assert max(ys) - min(ys) == pytest.approx(2 * float(radii.pop()), abs=0.02)


def test_a_whole_circle_is_three_pieces_so_that_none_could_go_the_other_way():
    (data,) = curves(f"{HEAD}G2 X0 Y0 I10\nM2", "top")
    assert len(re.findall("A", data)) == 3


def test_in_the_plane_of_z_and_x_clockwise_is_as_the_control_has_it():
    # G2 is clockwise for who looks from +Y. The front is seen from -Y, so there it goes counterclockwise: from the
    # left of the centre over its lower side to its top, three quarters of the circle.
    (data,) = curves(f"{HEAD}G18 G2 X10 Z10 I10\nM2", "front")
    assert sweeps(data) == {"0"}
    assert len(re.findall("A", data)) == 3


def test_a_helix_from_aside_and_an_arc_edge_on_are_chords():
    text = f"{HEAD}G2 X0 Y0 Z-5 I10\nM2"
    assert "A" in curves(text, "top")[0]
    for view in ("front", "right-side", "isometric"):
        assert "A" not in curves(text, view)[0]


def test_rapids_are_dashed_and_apart_from_cuts():
    text = f"{HEAD}G0 X10\nG1 X20\nM2"
    assert "stroke-dasharray" in picture("part", path_of(text))[0]
    assert len(curves(text, "top", "rapid")) == len(curves(text, "top", "cut")) == 1


def test_a_hole_seen_from_above_is_a_dot():
    (dots,) = curves(f"{HEAD}G0 Z2\nG1 Z-5\nG0 Z2\nX10\nG1 Z-5\nM2", "top", "hole")
    assert dots.count("h0") == 2
    assert curves(f"{HEAD}G1 X5\nM2", "top", "hole") == []


def test_each_tool_has_its_colour_and_a_place_in_the_legend():
    text = "G21 G90 F100\nT1 M6\nG1 X10\nT7 M6\nG1 X20\nM2"
    drawing = picture("part", path_of(text))[0]
    assert len(curves(text, "top")) == 2
    assert ">tool 1</text>" in drawing and ">tool 7</text>" in drawing


def test_bounds_units_and_notes_stand_in_the_picture():
    drawing = picture("part", path_of("G20 G90 F10\nG41 D1 G1 X1 Y0\nG0 Z2\nM2"))[0]
    assert "all moves: X 0 to 25.4, Y 0 to 0, Z 0 to 50.8 mm" in drawing
    assert "X (mm)" in drawing
    assert "compensation" in drawing


def test_names_and_notes_may_hold_what_xml_may_not():
    path = path_of("G0 X1\nM2")
    object.__setattr__(path, "notes", (Note(0, "a < b & \x07"),))
    ElementTree.fromstring(picture("<&>\x00", path)[0])


def test_a_program_without_moves_has_a_picture():
    root = ElementTree.fromstring(picture("part", path_of("G21\nM2"))[0])
    assert any("all moves: none" in (each.text or "") for each in root.iter())


def test_too_many_segments_are_fewer_and_the_picture_says_so():
    drawing, found = picture("part", path_of(rows(4_000)), most=500)
    assert found.tolerance > 0
    assert f"{len(found.segments):,} of 4,000 segments are drawn; what is left out lies within" in drawing


EXAMPLES = {
    "bolt_circle": ["rs274/bolt_circle.ngc"],
    "peck_drill": ["rs274/peck_drill.ngc"],
    "pocket_mgc": ["metagcode/pocket.mgc", "--variables", "metagcode/pocket.vars"],
    "mill": ["cgt/mill.cgt", "--input", "cgt/mill.cl", "-D", "DATE=1/6", "-D", "SYSTIME=9:30"],
    "pocket_z32": ["z32/pocket.z32"],
}


def test_the_picture_in_the_readme_is_that_of_its_example():
    docs = Path(__file__).parents[2] / "docs"
    assert (docs / "plot.svg").read_bytes() == (GOLDEN / "pocket_z32.svg").read_bytes()


@pytest.mark.parametrize("name", EXAMPLES)
def test_the_picture_of_an_example_is_the_one_that_was_looked_at(name, monkeypatch, capsysbinary):
    """`python -m pytest tests/plot --update-golden` does not exist on purpose: who changes a picture writes it by `deburr plot`, and looks at it."""
    from deburr.cli.main import main

    monkeypatch.chdir(Path(__file__).parents[2] / "examples")
    drawings = []
    for _ in range(2):
        assert main(["plot", *EXAMPLES[name]]) == 0
        drawings.append(capsysbinary.readouterr().out)
    assert drawings[0] == drawings[1] == (GOLDEN / f"{name}.svg").read_bytes()
