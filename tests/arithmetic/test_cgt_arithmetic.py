"""CGT's arithmetic, by hand from spec/cgt.md §5.8 and §11."""

import math
from decimal import Decimal

import pytest

from deburr.arithmetic import ArithmeticFault, Refusal
from deburr.arithmetic.cgt import constant, equal, function, holds, part_of, rounded
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.tree import Node


def value(expression: str) -> float | ArithmeticFault | None:
    """The value of an expression as `#EVAL` computes it."""
    text = f"#EVAL(#V1={expression})"
    node = Document.parse(f"@LINE\n{text}", by_name("cgt")).node(1)
    assert not node.problems
    evaluated = next(node.find("eval"))
    return constant(text, evaluated.children[4])


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("1+2*3", 7),
        ("(1+2)*3", 9),
        ("10-4-3", 3),
        ("100/10/5", 2),
        ("-2^2", 4),
        ("2^3^2", 64),
        ("2^-1", 0.5),
        ("+3", 3),
        (".5+2.", 2.5),
        ("ABS(-3)", 3),
        ("CEIL(-2.3)", -2),
        ("FLOOR(-2.3)", -3),
        ("INT(-2.7)", -2),
        ("INT(2.7)", 2),
        ("MAX(2,3)+MIN(2,3)", 5),
        ("MOD(9.8,7.3)", 2),
        ("MOD(-7,3)", -1),
        ("MOD(7,-3)", 1),
        ("RND(2.345,2)", 2.35),
        ("RND(-2.345,2)", -2.35),
        ("RND(0.5,0)", 1),
        ("RND(1250,-2)", 1300),
        ("SGN(-4)+SGN(0)*10", -1),
        ("SQR(16)", 4),
        ("DMS(30.3030)", 30.508333333333333),
        ("DMS(-1.3)", -1.5),
        ("SIN(180)", 0),
        ("SIN(-90)", -1),
        ("COS(90)", 0),
        ("COS(360)", 1),
        ("TAN(0)", 0),
        ("ATAN(1)", 45),
        ("ASIN(1)", 90),
        ("ACOS(-1)", 180),
        ("PI", math.pi),
        ("PI()", math.pi),
        ("sqr(9)", 3),
        ("0^0", 1),
    ],
)
def test_values(expression: str, expected: float) -> None:
    found = value(expression)
    assert isinstance(found, float) and found == pytest.approx(expected, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize("expression", ["#V1", "1+#V1", "SQR(#V1)", "JOS(x)", "TOTEL()", "FOO(1)", "MAX(1)", "abc"])
def test_what_only_the_run_knows_has_no_value(expression: str) -> None:
    assert value(expression) is None


@pytest.mark.parametrize(
    ("expression", "rule", "blamed"),
    [
        ("1/0", "divide-by-zero", "0"),
        ("#V1/(1-1)", "divide-by-zero", "(1-1)"),
        ("0^-1", "divide-by-zero", "0^-1"),
        ("MOD(1,0.5)", "divide-by-zero", "0.5"),
        ("MOD(#V1,-0.9)", "divide-by-zero", "-0.9"),
        ("SQR(-1)", "math", "SQR(-1)"),
        ("1+SQR(-0.1)", "math", "SQR(-0.1)"),
        ("ASIN(1.01)", "math", "ASIN(1.01)"),
        ("ACOS(-1.01)", "math", "ACOS(-1.01)"),
        ("TAN(270)", "math", "TAN(270)"),
        ("(-8)^0.5", "math", "(-8)^0.5"),
        ("10^308*10", "math", "10^308*10"),
        ("STRSUB(#S1,0,1)", "math", "STRSUB(#S1,0,1)"),
        ("9" * 400, "math", "9" * 400),
    ],
)
def test_faults_blame_the_operation(expression: str, rule: str, blamed: str) -> None:
    found = value(expression)
    assert isinstance(found, ArithmeticFault)
    text = f"#EVAL(#V1={expression})"
    assert (found.rule, text[found.part.start : found.part.end]) == (rule, blamed)
    assert isinstance(found.part, Node) or found.part.kind == "NUMBER"


@pytest.mark.parametrize(
    ("expression", "expected"), [("SQR(0)", 0), ("ASIN(1)", 90), ("MOD(5,1.9)", 0), ("(-8)^3", -512)]
)
def test_the_other_side_of_each_limit_has_a_value(expression: str, expected: float) -> None:
    assert value(expression) == expected


def test_equal_is_relative() -> None:
    assert equal(1e9, 1e9 + 0.5)
    assert not equal(1, 1 + 2e-9)
    assert equal(0, 0) and not equal(0, 1e-300)


@pytest.mark.parametrize(
    ("relation", "outcomes"),
    [
        ("=", (False, True, False)),
        ("<>", (True, False, True)),
        ("<", (True, False, False)),
        ("<=", (True, True, False)),
        (">", (False, False, True)),
        (">=", (False, True, True)),
    ],
)
def test_comparisons(relation: str, outcomes: tuple[bool, ...]) -> None:
    assert tuple(holds(relation, a, 2.0) for a in (1.0, 2.0, 3.0)) == outcomes


def test_at_most_includes_what_counts_as_equal() -> None:
    assert holds("<=", 2 + 1e-12, 2) and holds(">=", 2 - 1e-12, 2)


def test_rounding_takes_the_shortest_decimal_text() -> None:
    assert rounded(1.005, 2) == Decimal("1.01")
    assert rounded(-0.5, 0) == Decimal(-1)
    assert rounded(1.7e308, 3) == Decimal(repr(1.7e308))


def test_parts_of_texts_count_from_one_and_are_clipped() -> None:
    assert part_of("abcdef", 2, 3) == "bcd"
    assert part_of("abc", 3, 9) == "c"
    assert part_of("abc", 4, 1) == ""
    for start, length in ((0, 1), (1, -1)):
        with pytest.raises(Refusal):
            part_of("abc", start, length)


def test_functions_are_found_in_any_case() -> None:
    found = function("max")
    assert found is not None and found.takes == 2 and found.apply(1.0, 2.0) == 2
    assert function("NOPE") is None and function("STRSUB") is None
    assert value("MAX(1)") is None
