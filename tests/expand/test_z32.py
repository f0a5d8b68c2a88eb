"""Z32: what its reference says of every run, as properties (spec/z32.md §4 to §6)."""

import math
import re
from decimal import ROUND_HALF_UP, Context, Decimal
from fractions import Fraction
from itertools import permutations
from unittest.mock import patch

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from deburr.expand import Budget, Inputs
from deburr.expand.z32.written import written
from deburr_grammar.text import split_lines
from support.z32 import expanded, flat

decimals = st.decimals(-9999, 9999, places=4)
whole = st.integers(-999, 999)
finite = st.floats(allow_nan=False, allow_infinity=False)

# Programs of literal blocks: what a control would read as it stands.
literal = st.builds(
    "{}{}{}".format, st.sampled_from("XYZABCFSLT"), st.sampled_from(("", " ", "-", "+")), st.integers(0, 99999)
)
code = st.sampled_from(("G0", "G1", "G 90", "M3", "M08", "(a comment)", "( )", "X.5", "Y-1,5", "Z1."))
block = st.lists(st.one_of(literal, code), min_size=1, max_size=4).map(" ".join)
indent = st.sampled_from(("", " ", "/", "\t"))
plain = st.lists(st.builds("{}{}{}".format, indent, block, st.sampled_from(("", " ", "\t"))), max_size=6)


@given(plain, st.sampled_from(("\n", "\r\n", "\r")))
def test_a_program_of_literal_blocks_is_itself(lines: list[str], ending: str) -> None:
    program = ending.join(["(P)", *lines, ""])
    assert flat(program) == ["(P)", *lines]
    assert flat(f"TITLE{ending}%{ending}{program}") == ["(P)", *lines]


@given(st.lists(st.tuples(st.integers(0, 9999), block), max_size=6))
def test_block_numbers_and_texts_are_left_out_and_numbers_kept_if_asked_for(blocks: list[tuple[int, str]]) -> None:
    program = "".join(f"N{number} {text} ; and {number}\n" for number, text in blocks)
    assert flat(program) == [text for _, text in blocks]
    assert flat(program, keep_n=True) == [f"N{number} {text}" for number, text in blocks]


@given(decimals)
@example(Decimal("2.5"))
@example(Decimal("-2.5"))
def test_pal_is_always_an_integer_halves_away_from_zero(value: Decimal) -> None:
    (line,) = expanded(f"PAL[1]<{_term(value)}>\nX<PAL[1]>").lines
    assert Decimal(line[1:]) == value.quantize(Decimal(1), ROUND_HALF_UP)
    assert flat(f"PAR[1]<{_term(value)}>\nX<PAR[1]>") == [f"X{written(float(value))}"]


numbered = st.lists(
    st.builds(
        "{}{}{}".format,
        st.sampled_from(("", "N5 ", " N1.5", "/N7 ")),
        block,
        st.sampled_from(("", " ;t", ";(t)", "(c)")),
    ),
    max_size=6,
)


@given(numbered, st.booleans())
def test_lines_that_are_read_by_their_shape_do_what_others_do(lines: list[str], keep_n: bool) -> None:
    program = "\n".join(["X1 Y2 Z3 A4 B5 C6 F7 S8 L9 T10", *lines, "X<X+Y+Z+A+B+C+F+S+L+T>"])
    inputs = Inputs(keep_n=keep_n, block_delete=False)
    found = expanded(program, inputs=inputs)
    with patch("deburr.expand.z32.run.plain_of", return_value=None):
        assert expanded(program, inputs=inputs)[0] == found.lines


names = st.permutations("XYZ").map("".join)


@given(
    st.lists(st.one_of(names.map("G25{}".format), st.sampled_from(("AA1", "AB-2", "AC<PAR[1]>", "X7"))), max_size=10)
)
def test_an_alias_stands_for_the_axes_of_the_last_g25(words: list[str]) -> None:
    axes, wanted = "ZYX", list[str]()
    for word in words:
        if word.startswith("G25"):
            axes = word[3:]
        else:
            name = word[:1] if word[0] == "X" else axes["ABC".index(word[1])]
            wanted.append(name + word[2 - (word[0] == "X") :].replace("<PAR[1]>", "5"))
    program = "\n".join(["PAR[1]5", "G25ZYX", *words])
    assert flat(program) == wanted
    assert flat("PAR[1]5 G25ZYX " + " ".join(words)) == ([" ".join(wanted)] if wanted else [])


@given(st.sampled_from(list(permutations("XYZ"))), st.sampled_from(list(permutations("XYZ"))))
def test_two_aliases_in_turn_compose(one: tuple[str, ...], other: tuple[str, ...]) -> None:
    """What AA, AB and AC read under one G25 and write under the next goes from the first one's axes to the second one's."""
    program = f"X1 Y2 Z3\nG25{''.join(one)}\n!HA=AA; HB=AB; HC=AC!\nG25{''.join(other)}\nAA<HA> AB<HB> AC<HC>"
    before = dict(zip("XYZ", "123"))
    assert flat(program) == ["X1 Y2 Z3", " ".join(f"{to}{before[of]}" for of, to in zip(one, other))]


points = st.floats(-1e6, 1e6).filter(lambda value: abs(value) > 1)


@given(points, points)
def test_polar_and_back_is_the_same_point(x: float, y: float) -> None:
    given_values = {"HX": f"{x:.9f}", "HY": f"{y:.9f}"}
    lines = flat("!CP!\nX<HR> Y<HT>\n!PC!\nX<HX> Y<HY>", define=given_values, decimals=9)
    radius, angle = _values(lines[0])
    back = _values(lines[1])
    assert radius == pytest.approx(math.hypot(x, y), rel=1e-8) and -180 < angle <= 180
    assert back == pytest.approx((x, y), rel=1e-7, abs=1e-6)


@given(finite, st.integers(0, 15))
def test_a_computed_value_is_written_as_the_control_reads_it(value: float, places: int) -> None:
    text = written(value, places)
    if text is None:
        assert abs(value) >= 999_999_999.5 - 1e-6
        return
    assert re.fullmatch(r"-?(?:0|[1-9][0-9]*)(?:\.[0-9]*[1-9])?", text) and text != "-0"
    digits = text.lstrip("-").replace(".", "").lstrip("0")
    assert len(digits) <= 9 and len(text.partition(".")[2]) <= places
    exact = Decimal(repr(value))
    room = min(places, 8 - exact.adjusted()) if exact else 0
    assert Decimal(text) == Context(prec=800).create_decimal(exact).quantize(
        Decimal(1).scaleb(-room), ROUND_HALF_UP, Context(prec=800)
    )


@given(st.integers(1, 60), whole, st.integers(1, 9))
def test_a_loop_makes_its_passes_and_each_knows_its_number(passes: int, start: int, step: int) -> None:
    last = start + passes * step
    program = f"HA<{start}>\nN10 X<HA>\n!HA=HA+{step}; IF HA<{last}; GON10!\nX99999"
    expansion = expanded(program)
    assert expansion.lines == [*(f"X{start + step * each}" for each in range(passes)), "X99999"]
    frames = [[(each.kind, each.number) for each in expansion.source_map.stack(line)] for line in range(passes + 1)]
    assert frames == [*([("loop", each + 1)] for each in range(passes)), []]


# Advanced lines against a second reading of spec/z32.md §6.2.
conditions = st.builds("IF HA{}{}".format, st.sampled_from(("<", ">", "=", "<=", ">=", "<>")), st.integers(-1, 3))
assignments = st.builds("H{}={}".format, st.sampled_from("AB"), st.integers(-1, 3))
fields = st.one_of(conditions, assignments, assignments, st.just("EB"))
groups = st.lists(st.lists(fields, min_size=1, max_size=4), min_size=1, max_size=4)


@given(groups)
def test_fields_run_from_left_to_right_and_a_false_condition_skips_its_group(parts: list[list[str]]) -> None:
    values = {"A": 1, "B": 0}
    for group in parts:
        for field in group:
            if field == "EB":
                break
            if field.startswith("H"):
                values[field[1]] = int(field[3:])
            elif not _holds(field.removeprefix("IF HA"), values["A"]):
                break
        if field == "EB":
            break
    line = "!" + "!".join("; ".join(group) for group in parts) + "!"
    assert expanded(f"HA1 HB0\n{line}\nX<HA> Y<HB>").lines == [f"X{values['A']} Y{values['B']}"]


@given(st.lists(st.sampled_from(("X<HA>", "!HA=HA+1!", "HB<HA*2>", "G1 Y<HB> F100", "(c)")), max_size=8))
def test_a_range_does_what_a_section_does(body: list[str]) -> None:
    lines = "\n".join(body)
    ranged = f"HA1 HB2\n!GON10-N20!\n!GON10-N20!\nX99\nM30\nN10\n{lines}\nN20"
    called = f"HA1 HB2\n!GOP1!\n!GOP1!\nX99\nM30\n:1\n{lines}\nG26"
    assert flat(ranged) == flat(called)


@given(whole, whole)
def test_of_less_equal_and_more_exactly_one_holds(a: int, b: int) -> None:
    line = "!HB=0; IF X{}Y; HB=1!"
    found = {
        sign: flat(f"X{a} Y{b}\n{line.format(sign)}\nZ<HB>")[1] == "Z1" for sign in ("<", "=", ">", "<=", ">=", "<>")
    }
    assert [found["<"], found["="], found[">"]].count(True) == 1
    assert (found["<="], found[">="], found["<>"]) == (
        found["<"] or found["="],
        found[">"] or found["="],
        not found["="],
    )


# Arithmetic against exact fractions.
@st.composite
def sums(draw: st.DrawFn, depth: int = 0) -> tuple[str, Fraction]:
    """An expression and its value: small enough that doubles hold it exactly."""
    if depth == 3 or draw(st.booleans()):
        value = draw(st.integers(0, 40))
        return str(value), Fraction(value)
    (left, a), (right, b) = draw(sums(depth + 1)), draw(sums(depth + 1))
    sign = draw(st.sampled_from("+-*"))
    opener, closer = draw(st.sampled_from(("()", "<>")))
    value = a + b if sign == "+" else a - b if sign == "-" else a * b
    return f"{opener}{left}{sign}{right}{closer}", value


@given(sums())
def test_expressions_have_the_values_of_algebra(found: tuple[str, Fraction]) -> None:
    text, value = found
    if abs(value) > 999_999_999:
        assert expanded(f"X<{text}>").faults[0].kind == "number-digits"
    else:
        assert flat(f"X<{text}>") == [f"X{value}"]


@given(st.lists(whole, min_size=1, max_size=6), st.lists(st.sampled_from("+-*"), min_size=5, max_size=5))
def test_products_come_before_sums_and_all_go_from_left_to_right(numbers: list[int], signs: list[str]) -> None:
    text = "".join(f"{sign}{_term(number)}" for sign, number in zip(["", *signs], numbers))
    value = eval(text.replace("(0-", "(0 - "))
    if abs(value) <= 999_999_999:
        assert flat(f"X<{text}>") == [f"X{value}"]


sources = st.lists(
    st.sampled_from(
        (
            "X<HA>", "G1 Y<X/3> F100 ;t", "!HA=HA+1!", "N10 HB<HA> Z1", "/M8", "/G0 A<B+1>", "B5", "(c) HA3", "PAR[2]<HA>", "!GOP1!", "G25ZXY",
            "AA<PAR[2]>", "!IF HA>3; X=1; EB! X=2!", "N20", "%", "", "M<HA+40>",
        )
    ),
    max_size=10,
)  # fmt: skip


@given(sources)
def test_a_flat_program_is_its_own_expansion(lines: list[str]) -> None:
    program = "\n".join(["(P)", "HA1 X1 Y1 B2 PAR[2]1", "G25XYZ", *lines, "M30", ":1", "G0 X<HA+0.5>", "G26"])
    once = expanded(program, budget=Budget(1000, 0))
    if not once.faults:
        assert flat("\n".join(once.lines)) == once.lines


@given(sources, st.sampled_from(("\r\n", "\r")), st.sampled_from((True, False, None)))
def test_every_flat_line_comes_from_a_line_that_says_so(lines: list[str], ending: str, delete: bool | None) -> None:
    rows = ["(P)", "HA1 X1 Y1 B2 PAR[2]1", "G25XYZ", *lines, "M30", ":1", "G0 X<HA+0.5>", "G26"]
    found = expanded(ending.join(rows), inputs=Inputs(block_delete=delete))
    assert len(found.source_map) == len(found.lines)
    assert found.lines == expanded("\n".join(rows), inputs=Inputs(block_delete=delete)).lines
    for line, text in enumerate(found.lines):
        origin, row = found.source_map.origin(line), rows[found.source_map.origin(line).row]
        assert origin.file == "main.z32" and text.lstrip("/")[0] in row.replace("AA", "Z").replace("AA", "X") + "XYZ"
        assert bool(list(found.source_map.stack(line))) is (row == "G0 X<HA+0.5>")


def test_line_endings_are_those_of_the_grammar() -> None:
    assert split_lines("X1\rX2\r\nX3\nX4") == flat("X1\rX2\r\nX3\nX4")


def _term(value: Decimal | int) -> str:
    """A number where a sign may not stand."""
    return f"{value}" if value >= 0 else f"(0-{abs(value)})"


def _values(line: str) -> tuple[float, ...]:
    return tuple(float(word[1:]) for word in line.split())


def _holds(relation: str, value: int) -> bool:
    sign = relation.rstrip("-0123456789")
    other = int(relation[len(sign) :])
    return {
        "<": value < other,
        ">": value > other,
        "=": value == other,
        "<=": value <= other,
        ">=": value >= other,
        "<>": value != other,
    }[sign]
