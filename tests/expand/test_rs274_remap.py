"""RS274: codes to which a machine gives a meaning of its own (the setting `remap`)."""

import pytest

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr.schema import faults
from deburr_grammar.document import Document
from support.rs274 import DIALECT, expansion

REMAP = RuleSet(DIALECT, {"remap": ("m428", "G88.6", "M6")})
FOREIGN = {
    "a code that no table names": ("G0 X[1+1]\nM428 P1 Q2\nG0 X3\nM2\n", ["G0 X2", "M428 P1 Q2", "G0 X3", "M2"], ""),
    "with a point, axes and values": ("#1=2\nG88.6 X#1 L3 E4\nM2\n", ["G88.6 X2 L3 E4", "M2"], ""),
    "the position behind it": ("G0 X1\nM428\nG0 Y#5420\nM2\n", ["G0 X1", "M428"], "runtime-value 3"),
    "modes behind it": ("G90\nM428\n#1=#<_absolute>\nM2\n", ["G90", "M428"], "runtime-value 3"),
    "feed behind it": ("F100\nM428\nG0 X#<_feed>\nM2\n", ["F100", "M428"], "runtime-value 3"),
    "switches behind it": ("M428\nM8\nG0 X#<_flood>\nM2\n", ["M428", "M8"], "runtime-value 3"),
    "the tool behind it": ("T3 M6\nG0 X#<_selected_tool>\nM2\n", ["T3 M6"], "runtime-value 2"),
    "what is said anew": ("M428\nG90 G21 G54 G80 F7\nG0 X3 Y#<_feed>\nM2\n", ["M428", "G90 G21 G54 G80 F7", "G0 X3 Y7", "M2"], ""),
    "a cycle in a plane that is not known": ("M428\nG90 G81 X1 Z-1 R1 F9\n#1=#5422\nM2\n", ["M428", "G90 G81 X1 Z-1 R1 F9"], "runtime-value 3"),
    "modes that were saved before": ("G91\nM70\nM428\nM72\nG0 X1\nM2\n", ["G91", "M70", "M428", "M72", "G0 X1", "M2"], ""),
    "modes that were saved behind": ("M428\nM70\nG91\nM72\n#1=#<_absolute>\nM2\n", ["M428", "M70", "G91", "M72"], "runtime-value 5"),
}  # fmt: skip


@pytest.mark.parametrize("name", FOREIGN)
def test_a_code_of_the_machines_own_is_copied_and_nothing_is_known_behind_it(name: str) -> None:
    program, lines, fault = FOREIGN[name]
    errors = Analysis(Document.parse(program, DIALECT), REMAP).findings()
    assert [found for found in errors if found.severity is Severity.ERROR] == []
    found = expansion(program, rules=REMAP)
    assert found.lines == lines
    assert [f"{each.kind} {each.line + 1}" for each in found.faults] == ([fault] if fault else [])
    assert not fault or "which only the machine knows here" in found.faults[0].message


def test_a_code_that_is_not_named_is_still_unknown() -> None:
    document = Document.parse("M428\nM429\nG88.6\nG88.7\nM2\n", DIALECT)
    assert [(found.rule, found.place.line) for found in Analysis(document, REMAP).findings()] == [
        ("rs274.m-unknown", 1),
        ("rs274.g-unknown", 3),
    ]


def test_nothing_is_said_of_what_hangs_on_such_a_code() -> None:
    program = "M428 P1 Q2 I3\nX1 Y2\nG88.6 G0 G90 X1\nG1 X1\nG2 X1 I1\nM2\n"
    assert Analysis(Document.parse(program, DIALECT), REMAP).findings() == []


@pytest.mark.parametrize("said", ["T", "M", "428", "G88.66", "M4.5", "", "M428 P1"])
def test_what_is_no_code_is_no_setting(said: str) -> None:
    (fault,) = faults({"rs274": {"remap": ["M428", said]}})
    assert fault.message == f"`{said}` is no G or M code, such as `M428` or `G88.6`"
