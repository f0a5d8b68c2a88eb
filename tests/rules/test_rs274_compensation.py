"""RS274: inside arcs that are smaller than the tool beside them. Found is what LinuxCNC's interpreter refuses."""

import shutil
from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.oracle import complaints
from support.pages import MemoryHost
from support.rs274 import expansion

DIALECT = by_name("rs274")
REFUSED = {
    "to the left": ("G41.1 D10\nG1 X20\n", "G3 X24 I2"),
    "to the right": ("G42.1 D10\nG1 X20\n", "G2 X24 I2"),
    "the other way round": ("G41.1 D-10\nG1 X20\n", "G2 X24 I2"),
    "by R": ("G41.1 D10\nG1 X20\n", "G3 X22 Y2 R2"),
    "a large part of a circle": ("G41.1 D10\nG1 X20\n", "G3 X22 Y2 R-2"),
    "as the entry": ("G41.1 D10\n", "G3 X4 I2"),
    "the motion of the line before": ("G41.1 D10\nG1 X20\nG3 X40 I10\n", "X44 I2"),
    "in inches": ("G20\nG41.1 D10\nG1 X20\n", "G3 X24 I2"),
    "in steps": ("G91\nG41.1 D10\nG1 X20\n", "G3 X4 I2"),
}
ALLOWED = {
    "an outside arc": ("G41.1 D10\nG1 X20\n", "G2 X24 I2"),
    "a tool that is small enough": ("G41.1 D3.9\nG1 X20\n", "G3 X24 I2"),
    "no tool": ("G41.1 D0\nG1 X20\n", "G3 X24 I2"),
    "behind its end": ("G41.1 D10\nG1 X20\nG40\nG0 X20\n", "G3 X24 I2"),
    "another tool": ("G41.1 D10\nG1 X20\nG40\nG0 X20 Y0\nG41.1 D1\nG1 X22\n", "G3 X26 I2"),
}
SILENT = {
    "in other units": ("G21\nG41.1 D10\nG1 X20\nG20\n", "G3 X24 I2"),
    "behind a call": ("G41.1 D10\nG1 X20\nM98 P9\n", "G3 X24 I2"),
    "a diameter that the run tells": ("G41.1 D#1\nG1 X20\n", "G3 X24 I2"),
}


def found(text: str) -> list[int]:
    analysis = Analysis(Document.parse(text, DIALECT), RuleSet(DIALECT), "main", MemoryHost({}))
    return [each.place.line for each in analysis.findings() if each.rule == "rs274.inside-arc-small"]


def refused(text: str, folder: Path) -> bool:
    return "Tool radius not less than arc radius with comp" in complaints(text, folder) or (
        "Radius of cutter compensation entry arc is not greater than the tool radius" in complaints(text, folder)
    )


@pytest.mark.parametrize("name", REFUSED)
def test_an_inside_arc_smaller_than_the_tool_is_found(name: str, tmp_path: Path) -> None:
    before, arc = REFUSED[name]
    text = f"F100\n{before}{arc}\nM2\n"
    assert found(text) == [text.count("\n") - 2]
    assert not shutil.which("rs274") or refused(text, tmp_path)


@pytest.mark.parametrize("name", ALLOWED)
def test_an_arc_beside_which_the_tool_fits_is_not(name: str, tmp_path: Path) -> None:
    before, arc = ALLOWED[name]
    text = f"F100\n{before}{arc}\nG1 X60\nM2\n"
    assert found(text) == []
    assert not shutil.which("rs274") or not refused(text, tmp_path)


@pytest.mark.parametrize("name", SILENT)
def test_where_the_tool_is_not_certain_nothing_is_said(name: str) -> None:
    before, arc = SILENT[name]
    assert found(f"F100\n{before}{arc}\nM2\n") == []


def test_a_run_tells_the_diameter() -> None:
    text = "F100\n#1=10\nG41.1 D#1\nG1 X20\nG3 X24 I2\nM2\n"
    assert found(text) == []
    (fault,) = expansion(text).faults
    assert (fault.kind, fault.line) == ("inside-arc-small", 4)
