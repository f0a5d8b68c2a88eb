"""What viewers are given: columns that are the path again, and frames and lines in shares."""

import pytest

from deburr.expand.source_map import SourceMap
from deburr.fault import Entered, Frame
from deburr.motion import follow
from deburr.motion.arcs import points
from deburr.plot import columns
from deburr.plot.columns import Toolpath, every_chunk, header, scale
from deburr.plot.extent import reach
from support.plots import rows, toolpath, unpacked, unpacked_text

ARCS = "G21 G90 F100\nT2 M6\nG0 X10 Y0\nG3 X0 Y10 I-10\nG1 X-5\nG2 X-5 Y10 Z-3 I5 P3\nM2"


def joined(made: Toolpath, name: str) -> list[int]:
    return [value for chunk in every_chunk(made, scale(made)) for value in unpacked(chunk["columns"][name])]


def test_columns_are_the_moves_again():
    made = toolpath(ARCS)
    path = made.path
    assert joined(made, "kind") == list(path.kinds)
    assert [path.tools[tool] for tool in joined(made, "tool")] == [move.tool for move in path.moves()]
    assert joined(made, "row") == joined(made, "line") == list(path.flat)
    assert set(joined(made, "frame")) == {-1}


def test_points_are_the_ends_of_moves_with_points_of_arcs_between():
    made = toolpath(ARCS)
    path, fine = made.path, scale(made)
    expected = []
    for index in range(len(path)):
        arc = path.arc(index)
        expected += [path[index].end] if arc is None else list(points(arc, fine.tolerance))
    found = list(zip(*(joined(made, axis) for axis in "xyz")))
    assert len(found) == sum(joined(made, "vertices")) == len(expected)
    for quanta, point in zip(found, expected):
        assert [value * fine.quantum for value in quanta] == pytest.approx(point, abs=fine.quantum)


def test_chunks_one_behind_the_other_hold_everything_once(monkeypatch):
    whole = toolpath(rows(100))
    expected = {name: joined(whole, name) for name in ("x", "row", "vertices")}
    monkeypatch.setattr(columns, "CHUNK", 7)
    assert whole.chunks == 15
    assert {name: joined(whole, name) for name in expected} == expected
    texts = [unpacked_text(chunk["text"]) for chunk in every_chunk(whole, scale(whole))]
    assert "".join(texts) == "".join(f"{line}\n" for line in whole.flat)


def test_frames_come_in_shares_and_keep_their_numbers(monkeypatch):
    monkeypatch.setattr(columns, "CHUNK", 2)
    source_map = SourceMap()
    lines = [f"G1 X{number}" for number in range(9)]
    call = Frame(None, "/p/main.ngc", 3, Entered.CALL, 1)
    frames = [Frame(call, "/p/sub.ngc", 5, Entered.LOOP, number + 1) for number in range(9)]
    for number, frame in enumerate(frames):
        source_map.add("/p/sub.ngc", number, frame)
    path = follow(["F100", *lines][1:])
    made = Toolpath("main.ngc", path, source_map, lines, reach(path))
    assert joined(made, "frameParent") == [-1, *[0] * 9]
    assert joined(made, "frameNumber") == [1, *range(1, 10)]
    said = header(made, scale(made), [])
    assert [said["frameKinds"][kind] for kind in joined(made, "frameKind")] == ["call", *["loop"] * 9]


def test_a_program_without_moves_is_one_chunk_with_its_lines():
    made = toolpath("G21\nM2")
    (chunk,) = every_chunk(made, scale(made))
    assert unpacked(chunk["columns"]["kind"]) == []
    assert unpacked_text(chunk["text"]) == "G21\nM2\n"
    assert header(made, scale(made), [])["bounds"] == {"all moves": None, "cuts": None}


def test_positions_far_away_are_told_as_finely_as_whole_numbers_can():
    made = toolpath("G21 G90\nG0 X4e9\nG0 X0\nM2".replace("4e9", "4000000000"))
    fine = scale(made)
    assert joined(made, "x")[0] * fine.quantum == pytest.approx(4e9, rel=1e-8)
