"""RS274's arithmetic on constants: values by hand from spec/rs274.md §3 and spec/oracle.md §4."""

import pytest

from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.rs274 import constant
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from deburr_grammar.tree import Node


def value_of(expression: str, compare: str = "1e-4") -> object:
    line = f"X{expression}"
    node = Document.parse(line, by_name("rs274")).node(0)
    (word,) = node.find("word")
    value = constant(line, word.children[1], {"compare": compare})
    return value.rule if isinstance(value, ArithmeticFault) else value


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("1 2.5", 12.5),
        ("--3", 3.0),
        ("-[3]", -3.0),
        ("[2**3**2]", 64.0),
        ("[-2**2]", 4.0),
        ("[2.0 / 3 * 1.5 - 5.5 / 11.0]", 0.5),
        ("[-7 MOD 3]", 2.0),
        ("[7 MOD -3]", 1.0),
        ("[-7 MOD -3]", 2.0),
        ("[7.5 MOD 2]", 1.5),
        ("[0**0]", 1.0),
        ("[1 OR 0 AND 0]", 0.0),
        ("[1 OR 1 XOR 1]", 0.0),
        ("[3 GT 2 GT 1]", 0.0),
        ("[1 EQ 1+1]", 0.0),
        ("[1 EQ 1.00005]", 1.0),
        ("[1 GE 1.0000005]", 0.0),
        ("FIX[2.8]", 2.0),
        ("FIX[-2.8]", -3.0),
        ("FUP[2.8]", 3.0),
        ("FUP[-2.8]", -2.0),
        ("ROUND[2.5]", 3.0),
        ("ROUND[-2.5]", -3.0),
        ("ATAN[-1]/[-1]", -135.0),
        ("ATAN[0]/[0]", 0.0),
        ("ACOS[0.5]", 60.0),
        ("SQRT[9]", 3.0),
        ("SIN[30]", 0.5),
        ("SIN[180]", -5.016557612668332e-20),
        ("TAN[90]", -3.98679762981171e19),
        ("FIX[SIN[30]*10]", 5.0),
        ("[1/SIN[180]]", -1.9933988149058550e19),
        ("#1", None),
        ("[#1*0]", None),
    ],
)
def test_values(expression: str, value: float | None) -> None:
    assert (
        value_of(expression) == pytest.approx(value, rel=1e-15) if value is not None else value_of(expression) is None
    )


@pytest.mark.parametrize(
    ("expression", "value"), [("[1 EQ 1.00005]", 0.0), ("[1 GE 1.0000005]", 1.0), ("[1 GE 1.00005]", 0.0)]
)
def test_newer_versions_compare_nearer_and_also_ge(expression: str, value: float) -> None:
    assert value_of(expression, "1e-6") == value


@pytest.mark.parametrize(
    ("expression", "rule"),
    [
        ("[5/0]", "divide-by-zero"),
        ("[#1/[2-2]]", "divide-by-zero"),
        ("[1+[5/0]]", "divide-by-zero"),
        ("[5 MOD 0]", "not-finite"),
        ("[0**-1]", "not-finite"),
        ("EXP[1000]", "not-finite"),
        ("[10**400]", "not-finite"),
        ("[-8**0.5]", "domain"),
        ("SQRT[-1]", "domain"),
        ("LN[0]", "domain"),
        ("ACOS[1.0000001]", "domain"),
        ("ASIN[-1.1]", "domain"),
    ],
)
def test_faults(expression: str, rule: str) -> None:
    assert value_of(expression) == rule


def test_the_divisor_is_to_blame() -> None:
    node = Document.parse("X[1/[2-2]]", by_name("rs274")).node(0)
    (quotient,) = node.find("quotient")
    fault = constant(node.text, quotient, {"compare": "1e-4"})
    assert isinstance(fault, ArithmeticFault) and isinstance(fault.part, Node)
    assert node.text[fault.part.start : fault.part.end] == "[2-2]"
