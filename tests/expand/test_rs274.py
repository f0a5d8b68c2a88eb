"""RS274: what its reference says of every run, as properties (spec/rs274.md §3 to §7)."""

import math
from fractions import Fraction
from itertools import permutations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from deburr.expand import Inputs
from deburr.expand.job import EXACT
from support.programs import generated
from support.rs274 import flat, value

numbers = st.integers(-9999, 9999).map(lambda thousandths: thousandths / 1000)
small = st.integers(-40, 40).map(lambda halves: halves / 2)
words = st.sampled_from(
    ("G0 X1", "g1 y-.5 f100", "M3 S200", "(a comment)", "X1 ; behind", "", " G90", "G2 I1 (c)", "T1 M6")
)
LEVELS = (("**",), ("*", "/", "MOD"), ("+", "-"), ("EQ", "NE", "GT", "GE", "LT", "LE"), ("AND", "OR", "XOR"))
operators = st.sampled_from([operator for level in LEVELS for operator in level])


@given(st.lists(words, max_size=9), st.sampled_from(("M2", "M30")))
def test_a_program_without_values_is_itself(lines: list[str], end: str) -> None:
    assert flat("\n".join([*lines, end, "G0 X9", ""])) == [*lines, end]
    assert flat("\n".join(["%", *lines, "%", "G0 X9", ""])) == ["%", *lines, "%"]


@settings(max_examples=25)
@given(st.integers(0, 100_000))
def test_a_flat_program_is_its_own_expansion(seed: int) -> None:
    program = generated(seed)
    simulated = Inputs(simulate=True, decimals=EXACT, block_delete=False)
    once = flat(program.text, program.files, simulated)
    # What a message shows may look like a parameter.
    lines = [line for line in once if "#" not in line]
    assert flat("\n".join(lines), {}, simulated) == lines


@given(st.lists(st.tuples(operators, st.integers(1, 4)), min_size=1, max_size=5), st.integers(1, 4))
def test_brackets_that_the_table_implies_change_nothing(steps: list[tuple[str, int]], first: int) -> None:
    said = f"[{first}" + "".join(f" {operator} {number}" for operator, number in steps) + "]"
    terms: list[str] = [str(first), *(part for operator, number in steps for part in (operator, str(number)))]
    for level in LEVELS:
        terms = bracketed(terms, level)
    assert value(said) == value(f"[{terms[0]}]")


def bracketed(terms: list[str], level: tuple[str, ...]) -> list[str]:
    """Brackets around each operation of a level, from the left."""
    found = [terms[0]]
    for operator, term in zip(terms[1::2], terms[2::2]):
        if operator in level:
            found[-1] = f"[{found[-1]} {operator} {term}]"
        else:
            found += [operator, term]
    return found


@given(numbers, numbers.filter(bool))
def test_a_remainder_is_never_negative_and_fits(a: float, b: float) -> None:
    rest = value(f"[{a} MOD {b}]")
    assert 0 <= rest <= abs(b)
    turns = (a - rest) / b
    assert math.isclose(turns, round(turns), abs_tol=1e-6)


@given(numbers)
def test_rounding(a: float) -> None:
    down, up, near = value(f"FIX[{a}]"), value(f"FUP[{a}]"), value(f"ROUND[{a}]")
    assert down <= a <= up <= down + 1
    assert down == math.floor(a)
    assert near in (down, up)
    assert near == -value(f"ROUND[-[{a}]]")
    assert abs(near - a) <= 0.5
    assert abs(near) >= abs(a) or abs(near - a) < 0.5


@given(st.floats(-89.9, 89.9), numbers.filter(bool))
def test_angles_are_degrees(angle: float, y: float) -> None:
    said = f"{angle:.6f}"
    assert math.isclose(value(f"ATAN[SIN[{said}]]/[COS[{said}]]"), float(said), abs_tol=1e-9)
    assert math.isclose(value(f"ASIN[SIN[{said}]]"), float(said), abs_tol=1e-6)
    assert value(f"ATAN[{y}]/[0]") == math.copysign(90, y)


@given(st.permutations((1, 2, 3)), st.lists(numbers, min_size=3, max_size=3))
def test_settings_of_a_line_see_the_values_before_it(order: list[int], given: list[float]) -> None:
    before = " ".join(f"#{at}={number}" for at, number in enumerate(given, 1))
    items = [f"#{at}=#{source}" for at, source in enumerate(order, 1)]
    wanted = [given[source - 1] for source in order]
    for line in permutations(items):
        shown = flat(f"{before}\n{' '.join(line)}\n(PRINT,%.9f#1 #2 #3)\nM2\n", {}, Inputs(decimals=EXACT))
        assert shown[0] == "(PRINT,{:.9f} {:.9f} {:.9f})".format(*wanted)


@given(small)
def test_a_count_is_rounded_half_to_even(count: float) -> None:
    turns = max(round(Fraction(count)), 0)
    assert flat(f"#1={count}\no1 repeat [#1]\nG0 X1\no1 endrepeat\nM2\n") == ["G0 X1"] * turns + ["M2"]


@given(st.lists(numbers, max_size=30), st.integers(1, 30))
def test_arguments_belong_to_their_call(arguments: list[float], at: int) -> None:
    given = "".join(f" [{number}]" for number in arguments)
    seen = flat(f"o1 sub\n(PRINT,%.9f#{at})\n#{at}=7\no1 endsub\n#{at}=0.5\no1 call{given}\n(PRINT,%.9f#{at})\nM2\n")
    inside = arguments[at - 1] if at <= len(arguments) else 0.0
    assert seen == [f"(PRINT,{inside:.9f})", "(PRINT,0.500000000)", "M2"]


@given(st.lists(st.tuples(st.sampled_from("XYZ"), numbers), max_size=8), numbers)
def test_steps_sum_to_the_position(steps: list[tuple[str, float]], offset: float) -> None:
    moves = "".join(f"G0 {axis}{step}\n" for axis, step in steps)
    ends = [sum(step for letter, step in steps if letter == axis) for axis in "XYZ"]
    shown = flat(f"G91\n{moves}#1=#5420 #2=#<_y> #3=#5422\nG92 X{offset}\nG0 A[#1] B[#2] C[#3] X[#<_x>]\nM2\n")
    found = dict(zip("ABCX", (float(word[1:]) for word in shown[-2].split()[1:])))
    for letter, end in zip("ABC", ends):
        assert math.isclose(found[letter], end, abs_tol=1e-5)
    assert math.isclose(found["X"], offset, abs_tol=1e-5)


@given(st.floats(-1e9, 1e9))
def test_a_number_is_written_so_that_it_reads_back(number: float) -> None:
    program = "G0 X[#<v>]\nM2\n"
    define = {"v": repr(number)}
    (exact, _) = flat(program, {}, Inputs(define=define, decimals=EXACT))
    assert float(exact.removeprefix("G0 X")) == number
    (short, _) = flat(program, {}, Inputs(define=define))
    said = short.removeprefix("G0 X")
    assert "e" not in said
    assert len(said.partition(".")[2]) <= 6
    assert abs(Fraction(said) - Fraction(repr(number))) <= Fraction(1, 2_000_000)
    assert said not in ("-0", "")


@given(
    st.lists(st.tuples(st.integers(-9, 9), st.integers(1, 97)), min_size=1, max_size=40),
    st.sampled_from((1, 2, 4, 6)),
    st.sampled_from(("", " Z-1 R1", " Z-1 R1 L3")),
)
def test_a_chain_of_incremental_moves_ends_where_it_should(
    steps: list[tuple[int, int]], decimals: int, cycle: str
) -> None:
    code = "G81" if cycle else "G1"
    lines = [f"#1={top} #2={bottom}\n{code} X[#1/#2]{cycle}\n" for top, bottom in steps]
    found = flat(f"G91 F100\n{''.join(lines)}M2\n", {}, Inputs(decimals=decimals))[1:-1]
    times = 3 if "L3" in cycle else 1
    ends = [Fraction(line.split()[1].removeprefix("X")) * times for line in found]
    assert len(ends) == len(steps)
    wanted = sum(Fraction(top, bottom) * times for top, bottom in steps)
    assert abs(sum(ends) - wanted) <= Fraction(times, 10**decimals)
    assert all(
        abs(end - times * Fraction(*step)) <= Fraction(2 * times, 10**decimals) for end, step in zip(ends, steps)
    )


DIGITS = {
    "an arc in R form": (
        "G0 X#1\nG2 X1 R#1\nF#1",
        ["G0 X0.3333333333333333", "G2 X1 R0.3333333333333333", "F0.333333"],
    ),
    "its code on a line above": ("G2 I1\nX.5 R#1\nG4 P#1", ["G2 I1", "X.5 R0.3333333333333333", "G4 P0.333333"]),
    "its code is computed": ("G#3 X.5 R#1", ["G2 X.5 R0.3333333333333333"]),
    "other arcs": ("G0 X#1\nG2 X1 I#1", ["G0 X0.333333", "G2 X1 I0.333333"]),
    "cycles beside other arcs": (
        "G2 X[#1*2] I#1\nG81 X#1 Z-1 R#1",
        ["G2 X0.666667 I0.333333", "G81 X0.333333 Z-1 R0.333333"],
    ),
    "rotation": ("G2 X[#1*2] I#1\nG10 L2 P1 X#1 R#1", ["G2 X0.666667 I0.333333", "G10 L2 P1 X0.333333 R0.333333"]),
}


@pytest.mark.parametrize("name", DIGITS)
def test_coordinates_of_programs_with_arcs_in_r_form_keep_all_digits(name: str) -> None:
    program, lines = DIGITS[name]
    program = f"#1=[1/3] #3=2\nF9\n{program}\nM2\n"
    assert flat(program)[1:-1] == lines
    if name == "an arc in R form":
        assert flat(program, {}, Inputs(decimals=3))[1] == "G0 X0.333"


CHAINS = {
    "three thirds": ("G91\nG0 X#1\nX#1\nX#1", ["G0 X0.333333", "X0.333334", "X0.333333"]),
    "each axis by itself": ("G91 G0 X#1 Y#2\nX#1 Y#2", ["G91 G0 X0.333333 Y0.666667", "X0.333334 Y0.666666"]),
    "an absolute move ends it": ("G91 G0 X#1\nG90 X1\nG91 X#1", ["G91 G0 X0.333333", "G90 X1", "G91 X0.333333"]),
    "absolute moves are no chain": ("G0 X#1\nX#1\nX#1", ["G0 X0.333333", "X0.333333", "X0.333333"]),
    "offsets are no moves": ("G91 G92 X#1\nG92 X#1\nG92 X#1", ["G91 G92 X0.333333", "G92 X0.333333", "G92 X0.333333"]),
    "the depth of a cycle": ("G91 G81 X1 Z-#1 R#1 F9\nX#1 Z-#1 R#1\nX#1 Z-#1 R#1", ["G91 G81 X1 Z-0.333333 R0.333333 F9", "X0.333333 Z-0.333333 R0.333333", "X0.333334 Z-0.333333 R0.333333"]),
}  # fmt: skip


@pytest.mark.parametrize("name", CHAINS)
def test_what_is_a_chain(name: str) -> None:
    program, lines = CHAINS[name]
    found = [line for line in flat(f"#1=[1/3] #2=[2/3]\n{program}\nM2\n")[:-1] if line != "G91"]
    assert found == lines


COMPUTED_CODES = {
    "the end": ("#5=2\nG0 X1\nM#5\nG0 X2\n", ["G0 X1", "M2"]),
    "the end, with words before it": ("G0 X1 M[29+1]\nG0 X2\n", ["G0 X1 M30"]),
    "the end in a sub": ("o1 sub\nM[1+#1]\no1 endsub\no1 call [1]\nG0 X3\n", ["M2"]),
    "the end in percent signs": ("%\nM[2]\nG0 X3\n%\nG0 X4\n", ["%", "M2", "%"]),
    "the end at last": ("o1 repeat [3]\n#5=[#5+30] M#5\no1 endrepeat\n", ["M0", "M30"]),
    "a call": ("#5=98\nM#5 P7 L2\nM2\nO7\nG0 X3\nM99\n", ["G0 X3", "G0 X3", "M2"]),
    "a return": ("M98 P7\nM2\nO7\n#5=99\nG0 X3\nM#5\nG0 X4\nM99\n", ["G0 X3", "M2"]),
    "modes of a call": (
        "o1 sub\nM[#1+70]\nG91\no1 endsub\no1 call [3]\nM2\n",
        ["M70", "G91", "M72", "M2"],
    ),
    "one line, several codes": ("o1 repeat [2]\nM[7+#1]\n#1=1\no1 endrepeat\nM2\n", ["M7", "M8", "M2"]),
}
"""Programs with M codes that only a run knows, and what the control makes of them."""


@pytest.mark.parametrize("name", COMPUTED_CODES)
def test_a_computed_m_code_does_what_a_written_one_does(name: str) -> None:
    program, lines = COMPUTED_CODES[name]
    assert flat(program) == lines
