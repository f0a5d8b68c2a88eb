"""Moves that hang on where the tool stands: those that LinuxCNC's interpreter refuses are those in which something is found."""

import math
from collections.abc import Sequence
from itertools import accumulate, chain, pairwise
from pathlib import Path
from random import Random

import pytest

from deburr.analysis import Analysis
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.oracle import complaints
from support.pages import MemoryHost

pytestmark = pytest.mark.oracle
DIALECT = by_name("rs274")
ARCS, POLAR, CYCLES, TOOLS = 1_200, 600, 400, 400
PLANES = {"G17": ("XY", "IJ"), "G18": ("XZ", "IK"), "G19": ("YZ", "JK")}


def refused(program: str, folder: Path, *given: str) -> set[int]:
    """The numbers of the lines that the interpreter refuses; it goes on behind each."""
    said = complaints(program, folder, *given)
    return {int(line[1:].split()[0]) for line in said if line.startswith("N") and line[1:2].isdigit()}


def reported(program: str, *rules: str, table: str = "") -> set[int]:
    ruleset, host = RuleSet(DIALECT, {"tool-table": "t.tbl" if table else ""}), MemoryHost({"t.tbl": table})
    findings = Analysis(Document.parse(program, DIALECT), ruleset, "", host).findings()
    errors = [finding for finding in findings if finding.severity.name == "ERROR"]
    assert {finding.rule for finding in errors} <= set(rules)
    return {finding.place.line for finding in errors}


def arc(rng: Random) -> list[str]:
    """The way to where an arc starts, and the arc: right, nearly right, or wrong, in any plane, form and mode."""
    plane, steps, centre_steps = rng.choice(list(PLANES)), rng.random() < 0.3, rng.random() < 0.7
    axes, letters = PLANES[plane]
    diameter, before = rng.random() < 0.7, rng.random() < 0.5
    middle = [rng.uniform(-20, 20) for _ in axes]
    radius, angles = rng.choice([0.5, 5.0, 60.0]), [rng.uniform(0, 2 * math.pi) for _ in range(2)]
    start, end = ([m + radius * f(a) for m, f in zip(middle, (math.cos, math.sin))] for a in angles)
    off = rng.choice([0, 0, 0, 1e-4, 0.02, 0.027, 0.03, 0.1, 3])
    end = [value + off * rng.uniform(-1, 1) for value in end]
    x_first = 2 if before else 1
    words = [f"{axis}{value * (x_first if axis == 'X' else 1):.6f}" for axis, value in zip(axes, start)]
    lines = [f"G90 G91.1 {plane} {'G7' if before else 'G8'} G0 {' '.join(words)}"]
    way = rng.choice(
        ["", "G92 X3", "G10 L20 P1 X-4", "G10 L2 P3 X9", "G91 G0 X8\nX-8\nG90", "G53 G0 X0", "G20\nG21", "M3 S1"]
    )
    if way:
        lines += way.split("\n")
    if way[:3] in ("G92", "G10", "G53"):
        # The tool stands where it stood, or at a new X: an absolute way leads back, in the same mode.
        lines += [f"G0 {' '.join(words)}"]
    x_share = 2 if diameter else 1
    first, last = (end, start) if steps else (end, [0.0, 0.0])
    said = [f"{axis}{(to - from_) * (x_share if axis == 'X' else 1):.6f}" for axis, to, from_ in zip(axes, first, last)]
    if rng.random() < 0.25:
        said.append(f"R{rng.choice([1, -1]) * radius * rng.choice([1, 1, 1.5, 0.999, 0.6]):.6f}")
    else:
        base = start if centre_steps else [0.0, 0.0]
        said += [f"{letter}{to - from_:.6f}" for letter, to, from_ in zip(letters, middle, base)]
    code = "G7" if diameter else "G8"
    turn = f"{'G91' if steps else 'G90'} {'G91.1' if centre_steps else 'G90.1'} {rng.choice(['G2', 'G3'])} {' '.join(said)}"
    return [*lines, *([f"{code} {turn}"] if rng.random() < 0.5 else [code, turn])]


def test_arcs_under_g7_and_g8_are_judged_as_the_interpreter_judges_them(tmp_path: Path) -> None:
    rng = Random(7)
    lines = ["G21 F100", *(line for _ in range(ARCS) for line in arc(rng))]
    program = "".join(f"N{number} {line}\n" for number, line in enumerate(lines)) + "M2\n"
    stopped = refused(program, tmp_path)
    assert ARCS // 10 < len(stopped) < ARCS // 2
    assert reported(program, "rs274.arc-radius") == stopped


NAMED = ("", "", "G92 X0", "G92 X1", "G92 X0 Y0", "G7 X0\nG8", "G20\nG21", "G92.1\nX0 Y0")
RECKONED = ("G10 L20 P1 X0 Y0", "G91 X1\nX-1", "G91 Y2\nY-3", "G92.1", "G10 L2 P1 X0", "G43.1 X1", "G49")
"""Ways on which the control reckons where the tool stands: nothing is found behind them."""


def polar(rng: Random, ways: Sequence[str]) -> list[str]:
    """The way to a place, often the origin, and a move by polar words."""
    x, y = (rng.choice([0, 0, 0, 0.0001, 5]) for _ in range(2))
    said = rng.choice(["@3", "@-1", "^20", "@2 ^30", "@0 ^0", "@0", "^5", "^0"])
    move = rng.choice(["G0", "G1", "", "G81 Z-1 R1", "G83 Z-1 R1 Q1", "G38.3", "G33 K1"])
    return [
        f"G80 G90 G0 X{x} Y{y} Z0",
        *rng.choice(ways).split("\n"),
        f"{rng.choice(['G90', 'G91', ''])} {move} {said}",
    ]


@pytest.mark.parametrize(("ways", "all_found"), [(NAMED, True), (RECKONED, False)])
def test_polar_words_at_the_origin_are_judged_as_the_interpreter_judges_them(
    ways: Sequence[str], all_found: bool, tmp_path: Path
) -> None:
    rng = Random(5)
    lines = ["G21 F100 M3 S100", *(line for _ in range(POLAR) for line in polar(rng, ways))]
    program = "".join(f"N{number} {line}\n" for number, line in enumerate(lines)) + "M2\n"
    stopped = refused(program, tmp_path)
    assert POLAR // 10 < len(stopped) < POLAR // 2
    found = reported(program, "rs274.polar-at-origin")
    assert found == stopped if all_found else found <= stopped


def cycle(rng: Random) -> list[str]:
    """A canned cycle that goes on for some lines, with other levels, depths, planes, units and offsets."""
    plane, axis = rng.choice([("G17", "Z"), ("G18", "Y"), ("G19", "X")])
    across = "XYZ".replace(axis, "")
    turned, along = rng.choice([("G17", "Z"), ("G18", "Y"), ("G19", "X")])
    aside = "XYZ".replace(along, "")

    def number(letter: str) -> str:
        return f"{letter}{rng.choice([-3, -2, -1.5, -1, -0.5, 0, 0.5, 1, 2])}"

    def hole() -> str:
        return f"{rng.choice(across)}{rng.randint(-9, 9)}"

    lines = [
        f"G80 {plane} {rng.choice(['G90', 'G91'])}",
        f"{rng.choice(['G81', 'G82 P1', 'G85'])} {hole()} {axis}-2 {number('R')}",
    ]
    for _ in range(rng.randint(1, 5)):
        also = [number(letter) for letter in (axis, "R") if rng.random() < 0.4]
        mode = rng.choice(["", "", "", "G90", "G91", "G20", "G21", "G99"])
        lines.append(rng.choice([f"{mode} {hole()} {' '.join(also)}"] * 6 + ["G92 X3 Z4", "G4 P0", "G55", "M8"]))
    for said in (number(along), f"{rng.choice(aside)}3", f"{number(along)} {number('R')}", ""):
        # The numbers are taken over into another plane, and back.
        if rng.random() < 0.4:
            lines.append(f"{turned} {rng.choice(['', 'G90', 'G91']) if said else ''} {said}")
            turned = rng.choice(["", plane])
            along = axis if turned else along
    return lines


def test_levels_and_depths_that_a_cycle_takes_over_are_judged_as_the_interpreter_judges_them(tmp_path: Path) -> None:
    rng = Random(3)
    pieces = [cycle(rng) for _ in range(CYCLES)]
    lines = ["G21 F100", *(line for piece in pieces for line in piece)]
    program = "".join(f"N{number} {line}\n" for number, line in enumerate(lines)) + "M2\n"
    # Behind the first of a cycle the interpreter holds what that line said, and nobody would go on.
    stopped = firsts(refused(program, tmp_path), pieces)
    assert CYCLES // 10 < len(stopped) < CYCLES
    assert firsts(reported(program, "rs274.cycle-depth", "rs274.word-value"), pieces) == stopped


TABLE = "T1 P1 Z5 D1\nT2 P2\nT7 P3\n"
TOOL_LINES = (
    *(
        "T{}",
        "T{} G4 P0",
        "M61 Q{}",
        "G43 H{}",
        "G43.2 H{}",
        "G41 D{}\nG40",
        "G42 D{}\nG40",
        "T1 G43 H{} M8",
        "G43.1 Z{}",
    ),
    *(
        "G10 L1 P{} Z1",
        "G10 L10 P{} Z1",
        "G10 L11 P{} Z1",
        "G10 L2 P{} X0",
        "G4 P{}",
        "G41.1 D{}\nG40",
        "S{}",
        "G64 P{} Q{}",
    ),
)


def test_tools_are_asked_of_the_table_as_the_interpreter_asks_them(tmp_path: Path) -> None:
    rng = Random(9)
    lines = [rng.choice(TOOL_LINES).replace("{}", str(rng.choice([0, 1, 2, 3, 7, 8]))) for _ in range(TOOLS)]
    # That no tool can be measured is said by the rule on values.
    lines = [line for line in lines if not line.startswith("G10 ") or " P0" not in line]
    program = "".join(f"N{at} {line}\n" for at, line in enumerate("\n".join(lines).split("\n"))) + "M2\n"
    (tmp_path / "t.tbl").write_text(TABLE)
    stopped = refused(program, tmp_path, "-t", "t.tbl")
    assert TOOLS // 10 < len(stopped) < TOOLS // 2
    assert reported(program, "rs274.tool-unknown", table=TABLE) == stopped
    assert reported(program) == set()


def firsts(lines: set[int], pieces: Sequence[Sequence[str]]) -> list[int]:
    """The first of these lines in each piece; the pieces stand behind line 0."""
    ends = list(accumulate(map(len, pieces), initial=1))
    found = ([line for line in range(start, end) if line in lines][:1] for start, end in pairwise(ends))
    return list(chain.from_iterable(found))
