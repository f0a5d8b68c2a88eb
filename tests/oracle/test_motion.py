"""The moves of an expansion are those that LinuxCNC's interpreter makes of the program: kinds, ends, centres and turns (spec/oracle.md §3)."""

from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor

import pytest

from support.flat import Case
from support.motion import NEAR, canonical, difference, uncompensated
from support.oracle import SAMPLES
from support.programs import generated
from support.samples import drivers, sample

pytestmark = pytest.mark.oracle
PROGRAMS, CHUNKS = 600, 3
_CONTOUR = "G70 to G72 follow a contour in passes that the control works out; they are noted, and not shown"
EXCEPT: Mapping[str, str] = {
    "lathe_g70_71_demo.ngc": _CONTOUR,
    "lathe_g7x_face_boring.ngc": _CONTOUR,
    "lathe_g7x_quadrants.ngc": _CONTOUR,
}
"""Programs whose moves are not the interpreter's, on purpose."""


def said(cases: list[Case]) -> dict[str, str]:
    with ThreadPoolExecutor(2) as pool:
        return {case.name: why for case, why in zip(cases, pool.map(difference, cases)) if why}


def test_samples(capsys: pytest.CaptureFixture[str]) -> None:
    programs, calls = [sample(path) for path in sorted(SAMPLES.rglob("*.ngc"))], drivers()
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda case: case.original, [*programs, *calls]))
    clean = [case for case, run in zip([*programs, *calls], runs) if run.status == 0]
    whole = sum(run.status == 0 for run in runs[: len(programs)])
    assert whole == 120
    assert len(clean) - whole >= 150
    different = said(clean)
    compensated = sum(uncompensated(case) is not None for case in clean)
    moves = sum(len(list(canonical(case.original.calls))) for case in clean)
    with capsys.disabled():
        print(
            f"\nmotion: {len(clean) - len(different)} of {len(clean)} samples have the interpreter's moves"
            f" within {NEAR} ({whole} programs, {len(clean) - whole} calls of libraries; {moves:,} moves);"
            f" {compensated} of them are compared without cutter compensation, as they are shown"
        )
        for name, why in EXCEPT.items():
            print(f"  {name}: {why}")
    assert different.keys() == EXCEPT.keys(), different


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_random_programs(chunk: int) -> None:
    found = [(seed, generated(seed)) for seed in range(chunk, PROGRAMS, CHUNKS)]
    cases = [Case(str(seed), program.text, program.files) for seed, program in found if not program.misuse]
    run = [case for case in cases if case.original.status == 0 and not case.stopped]
    assert len(run) > len(found) // 2
    assert said(run) == {}


LATHE = ("P1 Z-5 I-1 J.3 K1", "P1 Z-5 I1 J.3 K1 R1.5 H2", "P1 Z5 I-1 J.3 K1 R2 Q29 E1 L3", "P1 Z-5 I2 J.3 K1 Q29 E1 L1")
RARE = {
    "splines": "G0 X1 Y2 Z3\nG5 X20 Y10 I1 J1 P-1 Q-1 F100\nG5 X3 Y3 P1 Q0\nG91 G5.1 X1 I1 J1",
    "boring": "G0 Z5 M3 S100 F100\nG88 X1 Z-1 R1 P1\nX2\nG87 X3 I1 J1 K0 Z-2 R1\nG18 G87 X3 I1 K1 J0 Y-2 R1\nG86 Y-3 R1 P1",
    "tapping": "G0 Z5\nG84 X1 Z-1 R1 S100 M3 F10\nG0 X2\nG33 Z-5 K1\nG33.1 Z-6 K1",
    "turned systems": "G10 L2 P1 R30 X5\nG0 X1 Y1\nG53 G0 X1\nG92 X3 Y2\nG0 X1\nG10 L20 P1 X5 Y7\nG0 X2 Y2\nG92.1\n"
    "X1\nG55\nX0\nG54 G2 X2 Y2 R5 F100\nG28 X0\nG30\nG28.1",
    "tool lengths": "T1 M6 G43\nG0 X1\nG91 X1 Z1\nG20 X1\nG90 G43.1 Z1 X2\nX1 Z1\nG21 G91 X1\nG43.2 H2\nX1 Z2\nG49 X2",
    "turned axes": "G0 A10 X1\nG91 A5 B3\nG92 A0\nA1\nG1 C5 F1",
    "saved modes": "M70\nG20 G0 X1\nM72\nG73 X1 Y1 Z-1 Q.3 R1 L2 F1\nG98 X2 Q.2\nG91 X1",
    "polar": "G0 @3 ^30\nG91 G81 @1 ^20 Z-1 R1 L3 F10\nG0 @1\n^10\nG90 G82 @2 Z-1 R1 P1",
    "planes": "F100\nG17.1\nG18 G3 X2 Z0 I1 Y3 P2\nG19 G2 Y1 Z1 R5\nG19 G81 X-3 Y1 Z1 R-1\nG90.1 G17 G2 X1 Y1 I0 J1",
}


@pytest.mark.parametrize("words", LATHE)
@pytest.mark.parametrize("head", ["G21 G18 G90", "G20 G18 G91", "G21 G7 G18 G90"])
def test_threads(words: str, head: str) -> None:
    assert difference(Case(words, f"{head} F100 S100 M3\nG0 X10 Z0\nG76 {words}\nG0 X0\nM2\n")) == ""


@pytest.mark.parametrize("name", RARE)
def test_rare_moves(name: str) -> None:
    case = Case(name, f"{RARE[name]}\nM2\n")
    assert case.original.status == 0, case.original
    assert difference(case) == ""
