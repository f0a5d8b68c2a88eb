"""The triggers of spec/rs274.md §8 on words and motion, as they stand there, and what must not be said."""

import pytest

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("rs274")


def rules_said(program: str, **settings: str) -> list[str]:
    findings = Analysis(Document.parse(program, DIALECT, size=20), RuleSet(DIALECT, settings)).findings()
    return [finding.rule.removeprefix("rs274.") for finding in findings]


TRIGGERS = {
    "word-repeated": ["G0 X1 X2"],
    "g-group": ["G0 G1 X1"],
    "m-group": ["M3 M4", "M7 M8"],
    "m-count": ["M0 M3 M6 M8 M48"],
    "axis-conflict": ["G28 G1 X1 F1"],
    "axis-no-motion": ["X1"],
    "word-unused": ["P1", "I1", "H1"],
    "g-unknown": ["G12", "G1.5"],
    "m-unknown": ["M55", "M200"],
    "m-user": ["M190"],
    "negative-value": ["F-1", "S-1", "T-1", "G-1"],
    "feed-missing": ["G1 X1"],
    "arc-form": ["F10\nG2 X1", "F10\nG2 X1 I1 R1"],
    "arc-radius": ["F10\nG2 X1 Y1 I0.3 J1"],
    "cycle-word": ["G81 X1 Z-1 F10"],
    "dwell-missing": ["G4"],
}


@pytest.mark.parametrize(("rule", "block"), [(rule, block) for rule, blocks in TRIGGERS.items() for block in blocks])
def test_a_trigger_gives_its_rule_and_no_other(rule: str, block: str) -> None:
    assert rules_said(DIALECT.frame.replace("{}", block)) == [rule]


def test_an_axis_that_the_machine_lacks() -> None:
    assert rules_said("F1\nG1 W1\nM2\n", axes="XYZ") == ["axis-letter"]
    assert rules_said("F1\nG1 W1\nM2\n", profile="smithy") == ["axis-letter"]
    assert rules_said("F1\nG1 W1\nM2\n") == []


UNCERTAIN = {
    "a block may have set the motion": "#1=1\no1 if [#1]\nG0\no1 endif\nX1\nM2\n",
    "a call may have set the feed rate": "o<a> sub\nF100\no<a> endsub\no<a> call\nG1 X1\nM2\n",
    "a sub does not know what holds before it": "o<a> sub\nX1 R1\nG1 Y2\no<a> endsub\nG0\no<a> call\nM2\n",
    "a loop may come from its end": "#1=0\no1 while [#1 LT 2]\nX1\nG0 Y1\n#1=[#1+1]\no1 endwhile\nM2\n",
    "the operator decides on a line": "/G1 F100\nX1\nM2\n",
    "a code may be any": "#1=81\nG#1 X1 R2 P3\nM2\n",
    "a move may lead anywhere": "F100\n#1=1\nG0 X#1 Y0\nG2 X5 I1\nM2\n",
    "an offset moves the origin": "F100\nG0 X0 Y0\nG52 X5\nG2 X9 R1\nM2\n",
    "M6 may move the machine": "F100\nG0 X0 Y0\nT1 M6\nG2 X9 R1\nM2\n",
    "an offset was stored, nobody knows which": "F100\nG0 X0 Y0\nG10 L2 P1 X5\nG2 X9 R1\nM2\n",
    "a tool may have an offset": "F100\nG0 X0 Y0\nG43 H1\nG2 X9 R1\nM2\n",
    "a tool may have an offset, and a step keeps it": "F100\nG0 X0 Y0\nG91 G43 H1 X1\nG90\nG2 X9 R1\nM2\n",
    "a probe stops on its way": "F100\nG0 X0 Y0\nG38.2 X5\nG2 X9 R1\nM2\n",
    "home is where the machine has it": "F100\nG0 X0 Y0\nG28 X5\nG2 X9 R1\nM2\n",
    "the machine's own coordinates": "F100\nG0 X0 Y0\nG53 G0 X5\nG2 X9 R1\nM2\n",
    "steps in units that are not known": "F100\nG91 G0 X1\nG90 G20\nG2 X9 R1\nM2\n",
    "a probe may turn": "F100\nG0 Z5\nG38.2 Z5 A3\nM2\n",
    "units change the numbers": "F100\nG0 X1 Y0\nG21\nG2 X9 R1\nM2\n",
}


@pytest.mark.parametrize("why", UNCERTAIN)
def test_what_is_not_certain_is_no_error(why: str) -> None:
    findings = Analysis(Document.parse(UNCERTAIN[why], DIALECT, size=20), RuleSet(DIALECT)).findings()
    assert [finding for finding in findings if finding.severity is Severity.ERROR] == []


CERTAIN = {
    "a branch changes nothing": ("#1=1\nG0\no1 if [#1]\nG0\no1 endif\nX1 P1\nM2\n", ["word-unused"]),
    "a code sets the motion in a sub": ("o<a> sub\nG80\nX1\no<a> endsub\no<a> call\nM2\n", ["axis-no-motion"]),
    "G80 beside a motion is passed over": ("F100\nG1 G80 X1\nX2\nM2\n", []),
    "splines do not stay": ("F100\nG0 X1\nG5.1 X1 Y1 I1 J1\nX2\nM2\n", []),
    "a feed mode forgets the feed rate": ("G1 X1 F100\nG94\nX2\nX3\nM2\n", ["feed-missing"]),
    "a rounded code is the code": ("G0.00001 X1\nX2\nM2\n", []),
    "the way of an arc is followed through chunks": (
        "F100\nG0 X0 Y0\n" + "G1 Z1\n" * 40 + "G2 X5 R1\nM2\n",
        ["arc-radius"],
    ),
    "arcs follow arcs": ("F100\nG0 X0 Y0\nG2 X2 I1\nX4 I1\nX9 I1\nX11 I1\nM2\n", ["arc-radius"]),
    "steps add up": ("F100\nG91 G0 X2\nX3\nG90 G2 X9 R1\nM2\n", ["arc-radius"]),
    "steps add up to a right start": ("F100\nG91 G0 X2\nX3\nG90 G2 X7 R1\nM2\n", []),
    "steps add up through chunks": ("F100\nG91\n" + "G1 X1\n" * 40 + "G90 G2 X44 R1\nG1\nX2\nM2\n", ["arc-radius"]),
    "steps add up through chunks, to a right start": ("F100\nG91\n" + "G1 X1\n" * 40 + "G90 G2 X42 R1\nM2\n", []),
    "arcs by steps follow each other": ("F100 G91\n" + "G2 X2 I1\n" * 20 + "G90 G2 X44 I1\nM2\n", ["arc-radius"]),
    "inches are 25.4 mm": ("G21 F100\nG0 X254\nG20\nG2 X12 R0.5\nM2\n", ["arc-radius"]),
    "inches are 25.4 mm, and the arc is right": ("G21 F100\nG0 X254\nG20\nG2 X11 R0.5\nM2\n", []),
    "units change far below": (
        "G21 F100\nG0 X254\n" + "G4 P1\n" * 30 + "G20\n" + "G4 P1\n" * 30 + "G2 X12 R0.5\nM2\n",
        ["arc-radius"],
    ),
    "a cycle ends above its hole": ("F100 G99\nG81 X5 Y0 Z-1 R1\nG80\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "a cycle ends at R": ("F100 G99\nG81 X5 Y0 Z-1 R3\nG80\nG18 G2 Z9 R1\nM2\n", ["arc-radius"]),
    "a repeated cycle ends at its last hole": ("F100 G91 G99\nG81 X5 Y0 Z-1 R1 L3\nG80 G90\nG2 X9 R1\nM2\n", []),
    "G92 names the place": ("F100\nG92 X5 Y0\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "G10 L20 names the place": ("F100\nG10 L20 P0 X5 Y0\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "another system is not in force": ("F100\nG10 L2 P2 X5 Y0\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "home along one axis": ("F100\nG0 X5 Y0\nG28 Z0\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "a probe along another axis": ("F100\nG0 X5 Y0 Z5\nG38.2 Z0\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "a probe far below where the tool stands": (
        "F100\nG0 Z5\n" + "G4 P1\n" * 30 + "G38.2 Z5\nM2\n",
        ["probe-in-place"],
    ),
    "X is a diameter": ("G7 G18 F100\nG0 X20 Z0\nG2 X10 Z-3 I2 K-1\nM2\n", ["arc-radius"]),
    "X is a diameter, and I is none": ("G7 G18 F100\nG0 X20 Z0\nG2 X10 Z-5 I-5 K0\nM2\n", []),
    "X is no diameter any more": ("G7 G18 F100\nG0 X20 Z0\nG8\nG2 X10 Z-3 I2 K-1\nM2\n", ["arc-radius"]),
    "a diameter through chunks": ("G7 G18 F100\nG0 X20\n" + "G4 P1\n" * 40 + "G2 X10 Z-5 I-10\nM2\n", ["arc-radius"]),
    "a level is no diameter": ("G7 G19 F100 G99\nG0 X20 Z0\nG81 X-10 Y0 R6\nG80 G17\nG2 X8 I-1\nM2\n", []),
    "a branch makes X a diameter": ("#1=1\nG18 F100\no1 if [#1]\nG7\no1 endif\nG0 X20 Z0\nG2 X10 Z-5 I-10\nM2\n", []),
    "zero is zero in all units": ("F100\nG0 X0 Y0\nG21\nG2 X9 R1\nM2\n", ["arc-radius"]),
    "an angle at the origin": ("G0 @5 ^3\nG0 Z5\n@2\nG0 X0 Y0\n@0 ^0\nG91\n^4\nM2\n", []),
    "no angle at the origin": ("G0 X9 Y9\nX0\nY0\n" + "G0 Z1\n" * 40 + "G0 @5\nM2\n", ["polar-at-origin"]),
    "steps that lead back may miss the origin": ("G0 X0.3 Y0\nG91 X-0.1\nX-0.1\nX-0.1\nG90 @5\nM2\n", []),
    "a system that is not in force, in compensation": ("G56\nG41 D1\nG10 L2 P1 X1\nG10 L2 P4 X1\nG40\nM2\n", []),
    "the system in force, in compensation": ("G56\nG41 D1\nG10 L2 P3 X1\nG40\nM2\n", ["in-compensation"]),
    "a level below a depth that is taken over": ("F9\nG81 X1 Z-1 R1\nX2\nX3 R-2\nM2\n", ["cycle-depth"]),
    "a depth that was taken over from another mode": ("F9\nG81 X1 Z0.5 R1\nG91 X2\nM2\n", ["cycle-depth"]),
    "a level below the depth of another plane": ("F9\nG0 Z20\nG81 X1 Y1 Z-1 R2\nG18 Y30\nM2\n", ["cycle-depth"]),
    "a plane of its own line": ("F9\nG18 G0 Y20\nG81 X1 Z1 Y-5 R2\nG19\nX30\nM2\n", ["cycle-depth"]),
    "the same cycle in another plane": ("F9\nG0 Z20\nG81 X1 Y1 Z-1 R2\nG18 G81 Y30\nM2\n", ["cycle-depth"]),
    "a depth of another plane": ("F9\nG81 X1 Y30 Z-1 R2\nG18 X30\nY2\nG17 X4\nR1 X5\nM2\n", ["cycle-depth"]),
    "a depth of another plane above no level": ("F9\nG81 X1 Y30 Z-1 R2\nG18 X30\nY2\nG19 Y4\nM2\n", []),
    "a level that is not known": (
        "F9\nG81 X1 Z-1 R1\nX3 R[#5-0.5]\nX4 R-3 Z-4\nX5 Z-4 R-3.5\nM2\n",
        ["read-before-set"],
    ),
    "a branch may change the level": ("F9\n#1=1\nG81 X1 Z-1 R1\no1 if [#1]\nR-9 Z-10 X2\no1 endif\nX3 Z-9.5\nM2\n", []),
    "a feed rate of zero": ("F0\nG0 X1\nG1 X2\nX3\nM2\n", ["feed-zero"]),
}


@pytest.mark.parametrize("why", CERTAIN)
def test_what_is_certain_is_said_once(why: str) -> None:
    program, expected = CERTAIN[why]
    assert rules_said(program) == expected


@pytest.mark.parametrize(
    ("table", "said"),
    {"T1 P1 Z5": ["arc-radius"], "T1 P1 X0.5 Z5": [], "T1 P1 Y0.5 Z5": []}.items(),
)
def test_a_tool_of_the_table_moves_along_its_own_offsets(table: str, said: list[str]) -> None:
    program = "F100\nG0 X5 Y0\nG43 H1 Z5\nG2 X9 R1\nM2\n"
    ruleset, host = RuleSet(DIALECT, {"tool-table": "t.tbl"}), MemoryHost({"t.tbl": f"{table}\n"})
    found = Analysis(Document.parse(program, DIALECT), ruleset, "", host).findings()
    assert [finding.rule for finding in found] == [f"rs274.{rule}" for rule in said]
    changed = Document.parse(program.replace("G43", "G10 L1 P1 X1\nG43"), DIALECT)
    assert Analysis(changed, ruleset, "", host).findings() == []


def test_an_unknown_code_in_a_file_of_subprograms_is_a_warning() -> None:
    program = "o<a> sub\nM69\nG12\no<a> endsub\n"
    findings = Analysis(Document.parse(program, DIALECT), RuleSet(DIALECT)).findings()
    assert {f.severity for f in findings if f.rule.endswith("-unknown")} == {Severity.WARNING}
