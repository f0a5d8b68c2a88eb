"""Lines of random words under known states: what the interpreter accepts has no error, and what it refuses has one, but for reasons that are listed."""

import random
import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.oracle import complaints

RS274 = by_name("rs274")
RULES = RuleSet(RS274)
CODES = [entry for entry in RS274.codes.table("code") if entry.first is None]
ENDS = ("M2", "M30", "M98", "M99")
"""They end the program or leave it, so that what follows on the same run would not be judged."""
_RESET = (
    "G5.3|G40|G49|G80|G97 S0|G93|G94|M5|M9|M48|M50 P1|M51 P1|M52 P0|M53 P0|G21|G90|G91.1|G17|G8|G98|G64"
    "|G54|G92.1|G10 L2 P1 X0 Y0 Z0 A0 B0 C0 R0|G10 L1 P1 Q0|G10 L1 P2 Q0|G0 X0 Y0 Z0 A0 B0 C0|G80|M71"
)
RESET = _RESET.split("|")
"""Lines that bring the interpreter back to its first state, in which no feed rate is known either."""
_STATES = (
    "|G0|G1 F100|F100|F100;G2 I1|F100;G81 R1 Z-1 X1|G18;F100|G91;F100|G93|G95 F1 S10|G41 D1;F100"
    "|M3 S100;F100|M3 S100;F100;G83 R1 Z-1 X1 Q1|M4 S5;F100;G18|G19 F10;G3 J2|G90.1 F9|F100;G38.2 X9"
    "|F100;G82 R1 Z-1 X1 P1;G80|M3 S100;F100;G33 Z1 K1|G18 M3 S1;G76 P1 Z-1 I-1 J0.1 K1|M3 S1;M5;F1"
    "|G1 F100;G94|G1 X1 F9;G92 X0"
)
STATES = _STATES.split("|")
EXCLUDED = {
    r"Requested tool|: $": "hangs on the tool table, or on the tool in the spindle",
    r"Invalid spindle|Spindle \(\$\) number": "hangs on how many spindles the machine has",
    r"\$ \(spindle selection\)": "this version takes `$` beside G95 and G97 only with S, other than its manual",
    r"too close to probe|polar coordinate if at the origin|entry move": "hangs on where the tool stands",
    r"R less than": "compares with what an earlier line has said",
    r"ontrol [Pp]oint": "hangs on the points of the curve before",
    r": .*(?:adius|Current point)": "hangs on where the tool stands; arcs are judged below",
    r"\$-1.*Bug code": "a fault of the interpreter's own",
    r"D-number in G76": "the interpreter names a letter that is not there",
}
Case = tuple[Sequence[str], str]


def refused(cases: Sequence[Case], folder: Path) -> dict[int, str]:
    """The cases whose line the interpreter refuses, with its message. One run judges all: with `-n 0` it goes on after an error."""
    text: list[str] = []
    for number, (state, line) in enumerate(cases):
        text += [f"N900000{each}" for each in (*RESET, *state)] + [f"N{number}{line}"]
    (folder / "tools.tbl").write_text("".join(f"T{n} P{n} D0.001\n" for n in range(1, 100)))
    said = complaints("\n".join([*text, "M2", ""]), folder, "-t", "tools.tbl")
    found = {}
    for message, echo in pairwise(said):
        echoed = re.match(r"N(\d+)", echo)
        if echoed and int(echoed[1]) < 900000 and not re.match(r"N\d", message):
            found[int(echoed[1])] = message
    return found


def errors(state: Sequence[str], line: str) -> list[str]:
    """What deburr says of the line behind the state."""
    text = "\n".join([*state, line, "M2", ""])
    found = Analysis(Document.parse(text, RS274), RULES).findings()
    return [f.message for f in found if f.severity is Severity.ERROR and f.place.line == len(state)]


def disagreements(cases: Sequence[Case], folder: Path) -> Iterator[tuple[str, Case, object]]:
    """Where the two judge otherwise."""
    messages = refused(cases, folder)
    for number, (state, line) in enumerate(cases):
        found, message = errors(state, line), messages.get(number)
        if message is None and found:
            yield "false", (state, line), found
        elif message is not None and not found and not any(re.search(why, f"{line}: {message}") for why in EXCLUDED):
            yield "silent", (state, line), message


def number(letter: str, pick: random.Random) -> str:
    match letter:
        case "T" | "H" | "D":
            return pick.choice(["1", "1", "2", "1.5", "-1", "[1]"])
        case "L":
            return pick.choice(["0", "1", "2", "2", "20", "10", "3", "-1", "1.5"])
        case "$":
            return pick.choice(["0", "-1"])
        case "P":
            return pick.choice(["0", "1", "2", "-1", "1.5", "3", "0.5", "10"])
        case _:
            return pick.choice(["0", "1", "2", "2", "1", "-1", "0.5", "1.5", "3", "-0.25", "10", "[2-1]", "-0", "--1"])


def code(pick: random.Random) -> str:
    return pick.choice([entry.name for entry in CODES if entry.name not in ENDS])


def any_words(pick: random.Random) -> str:
    """Words as they come, now and then two of a letter."""
    letters = pick.choices("XYZABCFSTDEHIJKLPQR$@^", [9, 9, 9, *[2] * 17, 1, 1], k=pick.randint(0, 5))
    kept = letters if pick.random() < 0.1 else dict.fromkeys(letters)
    words = [letter + number(letter, pick) for letter in kept] + [code(pick) for _ in range(pick.randint(0, 2))]
    pick.shuffle(words)
    return " ".join(words or ["G0"])


def nearly_right(pick: random.Random) -> str:
    """A code with most of the words that it takes."""
    entry = pick.choice([entry for entry in CODES if entry.name not in ENDS])
    letters = [letter for letter in entry.more["words"] if pick.random() < 0.8]
    words = [entry.name, *(letter + number(letter, pick) for letter in letters)]
    if entry.more["axes"]:
        words += [axis + pick.choice(["1", "-1", "2", "0.5"]) for axis in "XYZ" if pick.random() < 0.6]
    words += [code(pick)] if pick.random() < 0.2 else []
    words += ["F100"] if pick.random() < 0.2 and "F" not in letters else []
    pick.shuffle(words)
    return " ".join(words)


def goes_on(pick: random.Random) -> str:
    """Words without a code: whatever is in force takes them."""
    letters = dict.fromkeys(pick.choices("XYZXYZIJKRPQL", k=pick.randint(1, 4)))
    return " ".join(letter + number(letter, pick) for letter in letters)


@pytest.mark.oracle
@pytest.mark.parametrize("seed", [1, 2])
def test_random_lines_are_judged_alike(seed: int, tmp_path: Path) -> None:
    pick = random.Random(seed)
    makers = (any_words, nearly_right, nearly_right, goes_on)
    states = [[line for line in state.split(";") if line] for state in STATES]
    cases = [(pick.choice(states), pick.choice(makers)(pick)) for _ in range(200)]
    assert list(disagreements(cases, tmp_path)) == []


@pytest.mark.oracle
def test_every_code_alone_is_judged_alike(tmp_path: Path) -> None:
    cases = [(state, entry.name) for entry in CODES if entry.name not in ENDS for state in ([], ["M3 S100", "F100"])]
    assert list(disagreements(cases, tmp_path)) == []


NEAR, FAR = 0.02 * 2**0.5, 2 * 2**0.5


def off_centre(radius: float, apart: float) -> str:
    """A half circle whose centre is off: its two radii differ by so much."""
    return f"G2 X{2 * radius:.9f} I{radius + apart / 2:.9f} J0"


LIMITS = [
    *((["G21", "F9"], off_centre(5, NEAR + slip)) for slip in (-1e-5, 1e-5)),
    *((["G20", "F9"], off_centre(1, NEAR / 10 + slip)) for slip in (-1e-5, 1e-5)),
    *((["G21", "F9"], off_centre(100, 0.10005 + slip)) for slip in (-1e-5, 1e-5)),
    *((["G21", "F9"], off_centre(9000, FAR + slip)) for slip in (-1e-4, 1e-4)),
    *((["G20", "F9"], off_centre(900, FAR / 10 + slip)) for slip in (-1e-4, 1e-4)),
    *((["G21", "F9"], f"G2 X10 R{5 - 0.00127 + slip:.7f}") for slip in (1e-6, -1e-6)),
    *((["G20", "F9"], f"G2 X10 R{5 - 0.00005 + slip:.7f}") for slip in (1e-6, -1e-6)),
    *((["G21", "F9"], f"G2 I{0.00127 + slip:.7f}") for slip in (1e-6, -1e-6)),
    *((["G20", "F9"], f"G2 I{0.00005 + slip:.7f}") for slip in (1e-6, -1e-6)),
    *((["G18 F9", "G0 X1 Z2"], line) for line in ("G3 X3 Z4 I2", "G3 X3 Z4 I1", "G3 X3 R1", "G3 X1 R1")),
    *((["G19 F9 G91", "G0 X1 Z2"], line) for line in ("G3 Y2 Z2 J2", "G3 Y2 Z2 K3", "G3 Y5 R2", "G3 Y0 R2")),
    *((["G90.1 F9", "G0 X1 Y1"], line) for line in ("G2 X3 Y1 I2 J1", "G2 X3 Y1 I1 J0", "G2 I1 J1")),
    *((["F9", "G0 X1 Y1", "G1 Z5", "Y2"], line) for line in ("G2 X3 I1 Z1", "G2 X3 J1 Z1", "G2 Z4 I1", "G2 X1 Y2 R3")),
]


@pytest.mark.oracle
def test_arcs_are_judged_alike_on_both_sides_of_each_limit(tmp_path: Path) -> None:
    numbers = refused(LIMITS, tmp_path).keys()
    assert [number for number, case in enumerate(LIMITS) if bool(errors(*case)) is not (number in numbers)] == []
    assert [number for number in range(18) if number in numbers] == list(range(1, 18, 2)), "the second of each pair"
