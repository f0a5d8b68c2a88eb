"""RS274: the position in work systems that `G10` turns, as LinuxCNC's interpreter tells it."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from deburr.expand import Inputs
from deburr.ruleset import RuleSet
from support.rs274 import DIALECT, expansion

START = "G21 F100\n"
CASES = {
    "turned about the origin": ("G0 X1 Y2\nG10 L2 P1 R90\n", (2, -1)),
    "turned and laid": ("G0 X1 Y2\nG10 L2 P1 X10 Y0 R90\n", (2, 9)),
    "turned to and fro": ("G10 L2 P1 R30\nG0 X1 Y2\nG10 L2 P1 R0\nG10 L2 P1 R30\n", (1, 2)),
    "a move": ("G10 L2 P1 R30\nG0 X10 Y5\n", (10, 5)),
    "a step": ("G10 L2 P1 R90\nG91 G0 X3\nG90\n", (3, 0)),
    "another system": ("G10 L2 P2 X1 R90\nG0 X1 Y2\nG55\n", (2, 0)),
    "away from one": ("G10 L2 P1 X1 R90\nG0 X2 Y0\nG55\n", (1, 2)),
    "G92 and a turn that forgets it": ("G92 X5 Y1\nG10 L2 P1 X10 Y0 R90\n", (1, 5)),
    "G92 in a turned system": ("G10 L2 P1 R90\nG0 X1 Y2\nG92 X0\nG55\n", (-3, 1)),
    "laid for the place along one axis": ("G10 L2 P1 R90\nG0 X2 Y3\nG10 L20 P1 X0\nG10 L2 P1 R0\n", (-3, 0)),
    "another laid for the place": ("G10 L2 P2 R90\nG0 X2 Y3\nG10 L20 P2 X0 Y0\nG55\nG0 X1\nG54\n", (2, 4)),
    "another laid along one axis": ("G10 L2 P2 R90\nG0 X2 Y3\nG10 L20 P2 X0\nG55\n", (0, -2)),
    "a tool's offset": ("G10 L2 P1 R90\nG0 X5 Y5\nG43.1 X1\n", (5, 6)),
    "a move of the machine": ("G10 L2 P1 R90\nG0 X5 Y4\nG53 G0 X0\n", (5, 0)),
}
"""What is done, and the X and Y to which it leads, by hand."""


def told(program: str, folder: Path) -> list[float]:
    """What the interpreter's message says."""
    (folder / "p.ngc").write_text(program)
    done = subprocess.run(["rs274", "-g", "p.ngc"], cwd=folder, env={"HOME": str(folder), "PATH": "/usr/bin"},
                          capture_output=True, text=True, timeout=20, check=True)  # fmt: skip
    return numbers(done.stdout.split("MESSAGE(", 1)[1].split("\n")[0])


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?[0-9]+\.[0-9]+", text)]


@pytest.mark.parametrize("name", CASES)
def test_the_position_in_a_turned_system_is_that_of_the_interpreter(name: str, tmp_path: Path) -> None:
    done, expected = CASES[name]
    program = f"{START}{done}(debug, #5420 #5421)\nM2\n"
    found = expansion(program)
    assert not found.faults
    (said,) = (line for line in found.lines if "MSG" in line)
    assert numbers(said) == pytest.approx(expected, abs=1.5e-6)
    if shutil.which("rs274"):
        assert told(program, tmp_path) == pytest.approx(expected, abs=1.5e-6)


def test_a_rotation_has_no_unit_and_is_told() -> None:
    assert "G0 X30" in expansion("G10 L2 P1 R30\nG0 X#5230\nM2\n").lines


def test_stored_rotations_count() -> None:
    text = "G0 X1 Y2\nG10 L2 P1 R0\n(debug, #5420 #5421)\nM2\n"
    ruleset = RuleSet(DIALECT, {"parameters": "p.var"})
    found = expansion(text, {"p.var": "5230 90\n"}, Inputs(), rules=ruleset)
    (said,) = (line for line in found.lines if "MSG" in line)
    assert numbers(said) == pytest.approx((-2, 1))
