"""RS274: arcs behind offsets that the text or the stored parameters tell. Found is what LinuxCNC's interpreter refuses, and nothing where only the machine knows."""

import shutil
from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.oracle import complaints
from support.pages import MemoryHost

DIALECT = by_name("rs274")
ZERO = "5210 0\n"
"""Stored parameters of a machine without offsets: what is not there is 0."""
START = "G21 F100\nG0 X0 Y0 Z0\n"
SET_UP = "G10 L2 P1 X0 Y0 R0\nG10 L2 P2 X3 Y0 R0\nG52 X0 Y0\nG43.1 X0 Y0 Z0\nG0 X0 Y0\n"
CASES = {
    "a system that is laid": ("G10 L2 P1 X4\n", -4),
    "another that is laid": ("G10 L2 P2 X4\n", 0),
    "another system": ("G55\n", -3),
    "back in the first": ("G55\nG0 X1\nG54\n", 4),
    "the one in force by name": ("G54\n", 0),
    "a system laid for the place": ("G10 L20 P1 X6\n", 6),
    "another laid for the place": ("G10 L20 P2 X6\nG55\n", 6),
    "steps behind one": ("G10 L2 P1 X4\nG91 G0 X4\nG90\n", 0),
    "G92": ("G92 X6\n", 6),
    "G92 taken back": ("G92 X6\nG0 X9\nG92.1\n", 3),
    "G92 brought back": ("G92 X6\nG92.2\nG92.3\n", 6),
    "G92 forgotten": ("G92 X6\nG92.1\nG92.3\n", 0),
    "G52": ("G52 X5\n", -5),
    "a tool's offset": ("G43.1 X5\n", -5),
    "a tool's offset taken back": ("G43.1 X5\nG0 X5\nG49\n", 10),
    "other units": ("G10 L2 P1 X25.4\nG20\nG10 L2 P1 X1\nG21\n", -25.4),
    "a system turned by half": ("G0 X6\nG10 L2 P1 R180\n", -6),
    "turned about a place": ("G0 X6\nG10 L2 P1 X3 R180\n", -3),
    "turned away": ("G0 X0 Y6\nG10 L2 P1 R90\nG0 Y0\n", 6),
    "a move behind": ("G10 L2 P1 X4 R30\nG0 X0 Y0\n", 0),
    "a move beside a system": ("G10 L2 P1 X4\nG55 G0 X2\n", 2),
}
"""What is done, and the X to which it leads, by hand."""
SILENT = {
    "a system that is stored": "G55\n",
    "a system that is laid over a stored one": "G10 L2 P1 X4\n",
    "G52 over a stored one": "G52 X4\n",
    "an offset of a tool in a table": "G43 H1 X0\nG91 G0 Z0\nG90 G43.2 H2\n",
    "a G92 that may be stored": "G92.1\n",
    "what a block did": "G52 X0\nG0 X0\no1 if [#1 GT 0]\no1 endif\nG52 X4\n",
}


def found(text: str, settings: dict[str, str], machine: dict[str, str] | None = None, stored: str = ZERO) -> list[int]:
    analysis = Analysis(
        Document.parse(text, DIALECT),
        RuleSet(DIALECT, settings, machine=machine),
        "main",
        MemoryHost({"p.var": stored}),
    )
    return [each.place.line for each in analysis.findings() if each.rule == "rs274.arc-radius"]


def arc_from(x: float) -> str:
    return f"G2 X{x + 10:g} I5\n"


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("parameters", [True, False], ids=["stored", "told"])
def test_an_arc_is_judged_by_the_offsets_in_force(name: str, parameters: bool, tmp_path: Path) -> None:
    done, x = CASES[name]
    before = START + SET_UP + done
    settings = {"parameters": "p.var"} if parameters else {}
    for arc, fits in ((arc_from(x), True), (arc_from(x + 1), False)):
        text = f"{before}{arc}M2\n"
        assert found(text, settings) == ([] if fits else [before.count("\n")])
        if shutil.which("rs274"):
            assert (arc.strip() in complaints(text, tmp_path)) is not fits


@pytest.mark.parametrize("name", SILENT)
def test_where_only_the_machine_knows_nothing_is_said(name: str) -> None:
    assert found(f"{START}{SILENT[name]}{arc_from(1)}M2\n", {}) == []


def test_a_stored_length_counts_in_the_unit_of_the_machine() -> None:
    text = f"{START}G55\n{arc_from(-25.4)}M2\n"
    said = {
        unit: found(text, {"parameters": "p.var"}, {"unit": unit} if unit else None, "5241 1\n")
        for unit in ("inch", "mm", None)
    }
    assert said == {"inch": [], "mm": [3], None: []}


def test_offsets_far_above_count() -> None:
    lines = "".join(f"G1 X{at}\n" for at in range(600))
    text = f"{START}{SET_UP}{lines}G0 X0 Y0\nG52 X4\n{lines.replace('X', 'Z')}{arc_from(-4)}M2\n"
    assert found(text, {}) == []
    assert found(text.replace("G52 X4", "G52 X5"), {}) == [text.count("\n") - 2]
