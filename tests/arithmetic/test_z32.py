"""Z32's arithmetic, with values worked out by hand from spec/z32.md §4 and §9."""

import math

import pytest

from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.z32 import (
    COMPARISONS,
    constant,
    cosine,
    equal,
    evaluate,
    integer,
    nearest,
    sine,
    tangent,
    to_cartesian,
    to_polar,
)
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.tree import Node, Token


def _expression(text: str) -> tuple[str, Node | Token]:
    line = Document.parse(f"HA<{text}>", by_name("z32")).node(0)
    assert not line.problems
    return line.text, next(line.find("angle"))


def check_constant(text: str, value: float | None) -> None:
    assert constant(*_expression(text)) == value


def check_fault(text: str, rule: str, blamed: str) -> None:
    line, part = _expression(text)
    fault = constant(line, part)
    assert isinstance(fault, ArithmeticFault)
    assert (fault.rule, line[fault.part.start : fault.part.end]) == (rule, blamed)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1+2", 3.0),
        ("3+4*(2+3)", 23.0),
        ("3-4", -1.0),
        ("3/4", 0.75),
        ("2-3-4", -5.0),
        ("8/4/2", 1.0),
        ("2*3/4", 1.5),
        ("-2*-3", 6.0),
        ("-(1+2)", -3.0),
        ("+5", 5.0),
        ("<1+<2>>*3", 9.0),
        ("1,5+.5+2.", 4.0),
        ("SN(30)", 0.5),
        ("sn(30)", 0.5),
        ("CS(30)", math.sqrt(3) / 2),
        ("TAN(30)", 0.57735026918962576451),
        ("AT(1)", 45.0),
        ("AT(-1)", -45.0),
        ("ABS(-2.7)", 2.7),
        ("INT(-2.7)", -2.0),
        ("INT(2.7)", 2.0),
        ("NEI(-2.7)", -3.0),
        ("NEI(2.5)", 3.0),
        ("NEI(-2.5)", -3.0),
        ("NEI(2.4)", 2.0),
        ("RQ(9)", 3.0),
        ("RQ(0)", 0.0),
        ("PI", math.pi),
        ("HA", None),
        ("1+HA", None),
        ("PAR[1]*0", None),
        ("SN(HA)", None),
    ],
)
def test_constants(text: str, value: float | None) -> None:
    check_constant(text, value)


@pytest.mark.parametrize(
    ("text", "rule", "blamed"),
    [
        ("1/0", "divide-by-zero", "0"),
        ("1/(2-2)", "divide-by-zero", "(2-2)"),
        ("HA/0", "divide-by-zero", "0"),
        ("HA+1/0", "divide-by-zero", "0"),
        ("HA/SN(180)", "divide-by-zero", "SN(180)"),
        ("1/-0.0", "divide-by-zero", "-0.0"),
        ("RQ(-1)", "domain", "RQ(-1)"),
        ("HA*RQ(0-1)", "domain", "RQ(0-1)"),
        ("TAN(90)", "domain", "TAN(90)"),
        ("TAN(-270)", "domain", "TAN(-270)"),
        ("RQ(-1)/0", "domain", "RQ(-1)"),
    ],
)
def test_faults_blame_the_innermost_part(text: str, rule: str, blamed: str) -> None:
    check_fault(text, rule, blamed)


def test_overflow_is_a_fault_of_the_operation() -> None:
    check_fault("*".join(["999999999"] * 40), "domain", "*".join(["999999999"] * 40))


def test_parameters_are_asked_for() -> None:
    text, part = _expression("HA*2+PAR[HB]")

    def read(name: Node | Token) -> float:
        return {"HA": 3.0, "PAR[HB]": 0.5}[text[name.start : name.end]]

    assert evaluate(text, part, read) == 6.5


@pytest.mark.parametrize(
    ("degrees", "value"),
    [
        (0, 0),
        (30, 0.5),
        (90, 1),
        (150, 0.5),
        (180, 0),
        (210, -0.5),
        (270, -1),
        (330, -0.5),
        (360, 0),
        (750, 0.5),
        (-30, -0.5),
        (-210, 0.5),
    ],
)
def test_sine_and_cosine_are_exact_at_multiples_of_30(degrees: float, value: float) -> None:
    assert sine(degrees) == value
    assert cosine(degrees - 90) == value


@pytest.mark.parametrize(("degrees", "value"), [(0, 0), (45, 1), (135, -1), (180, 0), (225, 1), (-45, -1)])
def test_tangent_is_exact_at_multiples_of_45(degrees: float, value: float) -> None:
    assert tangent(degrees) == value


@pytest.mark.parametrize("degrees", [90, -90, 270, 450])
def test_tangent_has_no_value_at_odd_multiples_of_90(degrees: float) -> None:
    assert tangent(degrees) is None


def test_sine_of_45_is_correctly_rounded() -> None:
    assert sine(45) == cosine(45) == 0.7071067811865476


@pytest.mark.parametrize("degrees", range(-360, 361, 7))
def test_other_angles_agree_with_radians(degrees: int) -> None:
    assert sine(degrees) == pytest.approx(math.sin(math.radians(degrees)), abs=1e-15)
    assert cosine(degrees) == pytest.approx(math.cos(math.radians(degrees)), abs=1e-15)


@pytest.mark.parametrize(("value", "whole"), [(0.5, 1), (-0.5, -1), (1.4999999999999998, 1), (1e300, 1e300), (0.0, 0)])
def test_nearest(value: float, whole: float) -> None:
    assert nearest(value) == whole


@pytest.mark.parametrize(
    ("value", "whole"), [(3.0, 3), (3.0000009, 3), (3.0000011, None), (2.9999991, 3), (2.9999989, None), (2.5, None)]
)
def test_integer_within_a_millionth(value: float, whole: int | None) -> None:
    assert integer(value) == whole


def test_equality_is_relative() -> None:
    assert equal(1.0, 1.0 + 0.9e-9) and not equal(1.0, 1.0 + 1.1e-9)
    assert equal(1e6, 1e6 + 0.9e-3) and not equal(1e6, 1e6 + 1.1e-3)
    assert equal(0.0, 1e-9) and not equal(0.0, 1.1e-9)


@pytest.mark.parametrize(
    ("relation", "less", "same", "more"),
    [
        ("=", False, True, False),
        ("<>", True, False, True),
        ("<", True, False, False),
        ("<=", True, True, False),
        (">", False, False, True),
        (">=", False, True, True),
    ],
)
def test_comparisons_agree_with_equality(relation: str, less: bool, same: bool, more: bool) -> None:
    compare = COMPARISONS[relation]
    assert (compare(1.0, 2.0), compare(1.0, 1.0 + 1e-10), compare(2.0, 1.0)) == (less, same, more)


def test_polar_conversion() -> None:
    assert to_polar(1.0, 1.0) == (math.sqrt(2), 45.0)
    assert to_polar(-1.0, 0.0) == (1.0, 180.0)
    assert to_polar(-1.0, -0.0) == (1.0, 180.0)
    assert to_polar(0.0, 0.0) == (0.0, 0.0)
    assert to_cartesian(1.0, 45.0) == (0.7071067811865476, 0.7071067811865476)
    assert to_cartesian(2.0, 150.0) == (-math.sqrt(3), 1.0)
