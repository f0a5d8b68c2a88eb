"""Rules on the moves of a run, in all dialects: the source line with its calls and passes; silent without `[machine]`, and where only the machine knows."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding
from deburr.ran import Aside, ran
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from support.code import ROOT
from support.pages import MemoryHost

LIMITS = {"limits": {"X": [0, 300], "Z": [-50, 100]}}
RULES = ("outside-limits", "rapid-below-safe", "cut-without-spindle", "cut-without-feed")

FRAMED: Mapping[str, tuple[str, Mapping[str, str], Mapping[str, object], list[str]]] = {
    "rs274": (
        "o1 sub\nG0 X[#1*100]\no1 endsub\n#2=1\no2 repeat [5]\no1 call [#2]\n#2=[#2+1]\no2 endrepeat\nM2\n",
        {},
        {},
        ["2: the move goes to X 400 mm", "6 called here", "5 in pass 4 of the loop that starts here"],
    ),
    "metagcode": (
        "G0 X0\nG91\n#LOOP1 |Run| |Step| r\nG0 X|Run|\n#ENDLOOP1\nM30\n",
        {"part.vars": "Run=500\nStep=100\n"},
        {"variables": "part.vars"},
        ["4: the move goes to X 400 mm", "3 in pass 4 of the loop that starts here"],
    ),
    "z32": (
        "(P)\n!HA=1!\nN10 G0 X<HA*100>\n!HA=HA+1; IF HA<6; GON10!\nM30\n",
        {},
        {},
        ["3: the move goes to X 400 mm"],
    ),
    "cgt": (
        "@START\nG90\n@\n@LINE\nG0 X#XPOS\n@\n@END\nM30\n@\n",
        {"part.jsonl": '{"section": "START"}\n{"section": "LINE", "set": {"XPOS": 300}}\n{"section": "LINE", "set": {"XPOS": 400}}\n'},
        {"input": "part.jsonl"},
        ["5: the move goes to X 400 mm", "3 run from here"],
    ),
}  # fmt: skip
"""Of each dialect a program that moves to X 400 in a call or a pass, its files, settings, and what is said of it."""


def said(
    dialect: str,
    text: str,
    machine: Mapping[str, object],
    files: Mapping[str, str] | None = None,
    settings: Mapping[str, object] | None = None,
) -> list[Finding]:
    language = by_name(dialect)
    ruleset = RuleSet(language, settings, machine=machine)
    analysis = Analysis(Document.parse(text, language), ruleset, "main", MemoryHost(files or {}))
    return [found for found in ran(analysis) if found.rule.partition(".")[2] in RULES]


@pytest.mark.parametrize("dialect", NAMES)
def test_a_move_is_told_with_its_calls_and_passes(dialect: str) -> None:
    text, files, settings, expected = FRAMED[dialect]
    found = said(dialect, text, LIMITS, files, settings)[0]
    assert found.rule == f"{dialect}.outside-limits"
    first, *frames = expected
    assert f"{found.place.line + 1}: {found.message}".startswith(first)
    told = [f"{each.place.line + 1} {each.message}" for each in found.related]
    assert told[: len(frames)] == frames, told
    assert all(each.entered for each in found.related)
    assert said(dialect, text, {}, files, settings) == []


def messages(text: str, machine: Mapping[str, object], **settings: object) -> list[str]:
    files = {"p.var": "5223 -400\n5162 0\n", "t.tbl": "T1 P1 Z60\n"}
    return [f"{found.place.line + 1} {found.rule}" for found in said("rs274", text, machine, files, settings)]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        pytest.param("G28\nG0 X400", [2], id="said again behind G28"),
        pytest.param("G28 X400\nG91 G0 X1000\nG90 G1 F1 Y1", [1], id="steps from where only the machine knows"),
        pytest.param("G53 G0 Z500\nG0 Y1\nG0 Z5", [1], id="a place of the machine's own, whatever its offsets are"),
        pytest.param("G28\nG53 G0 Y1\nG53 G0 Z-10", [], id="only the axes that G53 names are in a known place"),
        pytest.param("G91 G0 X-5\nG0 X500", [], id="steps from the start"),
        pytest.param("G92 X1000\nG0 X1100\nG0 X5000", [], id="G92 where the machine stands"),
        pytest.param("G0 X0 Y0\nG92 X1000\nG0 X1100\nG0 X1500", [4], id="G92"),
        pytest.param("G10 L2 P1 X250\nG0 X50\nX51", [3], id="offset"),
        pytest.param("G0 Z40\nG43.1 Z60\nG0 Z40\nZ41", [4], id="tool length"),
        pytest.param("G0 X290 Y0 Z0\nG18 G2 X290 Y5 Z30 I0 K15 F9", [2], id="an arc out of it and back"),
        pytest.param("G0 X290 Y0 Z0\nG18 G3 X290 Y5 Z30 I0 K15 F9", [], id="an arc on the other side"),
        pytest.param("G0 X400 Y0 Z0\nG0 Z5\nX401\nG1 Y7 F9\nX5", [1, 3], id="only what brings it there"),
        pytest.param("G20 G0 X11.811\nX12", [2], id="inches"),
        pytest.param("G0 X50 A7000", [], id="an axis without limits"),
    ],
)
def test_what_is_outside(text: str, lines: list[int]) -> None:
    assert messages(f"M3 S1\n{text}\nM2", LIMITS) == [f"{line + 1} rs274.outside-limits" for line in lines]


def test_offsets_and_tools_that_are_known_count() -> None:
    home = "G53 G0 Z500\nG0 Z10\nM2"
    assert messages(home, LIMITS, parameters="p.var") == ["1 rs274.outside-limits", "2 rs274.outside-limits"]
    assert messages("G43 H1\nG0 Z50\nM2", LIMITS) == []
    assert messages("G43 H1\nG0 Z50\nM2", LIMITS, **{"tool-table": "t.tbl"}) == ["2 rs274.outside-limits"]


UNGIVEN = "; the work offset counts as 0, since nothing gives it"
BOTH = "; the work offset and the length of tool 7 count as 0, since nothing gives them"
FAR = "the move goes to X 400 mm, outside of the machine's limits 0 to 300"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        pytest.param("G0 X400", [FAR + UNGIVEN], id="no offset"),
        pytest.param("G10 L2 P1 X10\nG0 X390", [FAR], id="one that the program gives"),
        pytest.param("G10 L2 P1 X10\nG55 G0 X400", [FAR + UNGIVEN], id="one that it gives to another system"),
        pytest.param("G10 L2 P2 X10\nG0 X1\nG55 G0 X390", [FAR], id="one that it gives to a system that it uses later"),
        pytest.param("G53 G0 X400", [FAR], id="the machine's own place"),
        pytest.param("G43 H7\nG0 X400", [FAR + UNGIVEN], id="a tool is no longer in X"),
        pytest.param(
            "G43 H7\nG0 X400 Z-60",
            [f"{FAR}, and Z -60 mm, outside of -50 to 100{BOTH}"],
            id="two axes, and a tool of which nothing gives the length",
        ),
        pytest.param("G43 H1\nG0 Z90", ["the move goes to Z 150 mm, outside of the machine's limits -50 to 100" + UNGIVEN], id="a tool of the table"),
        pytest.param("G43 H7\nG49\nG53 G0 Z150", ["the move goes to Z 150 mm, outside of the machine's limits -50 to 100"], id="a tool that is put away"),
    ],
)  # fmt: skip
def test_what_counts_as_zero_is_said(text: str, told: list[str]) -> None:
    settings = {"tool-table": "t.tbl"}
    found = said("rs274", f"M3 S1\n{text}\nM2", LIMITS, {"t.tbl": "T1 P1 Z60\n"}, settings)
    assert [each.message for each in found] == told


def test_stored_offsets_are_given() -> None:
    found = said("rs274", "G0 X410\nM2\n", LIMITS, {"p.var": "5221 -10\n"}, {"parameters": "p.var"})
    assert [each.message for each in found] == [FAR]


def test_all_axes_of_an_arc_are_named() -> None:
    text = "M3 S1\nG0 X290 Y0 Z80\nG18 G2 X290 Y0 Z120 I0 K20 F9\nM2\n"
    expected = "the arc reaches X 310 mm, outside of the machine's limits 0 to 300, and Z 120 mm, outside of -50 to 100"
    assert [each.message.removesuffix(UNGIVEN) for each in said("rs274", text, LIMITS)] == [expected]


def test_a_rapid_below_safe_says_what_counts_as_zero() -> None:
    for text, end in (("G0 Z1", UNGIVEN), ("G10 L2 P1 Z0.5\nG0 Z1", "")):
        found = said("rs274", f"{text}\nM2\n", {"z-safe": 2})
        assert [each.message.partition(" off")[2] for each in found] == [end]


@pytest.mark.parametrize("dialect", ["metagcode", "z32"])
@pytest.mark.parametrize(
    ("text", "unit", "lines", "unsaid"),
    [
        pytest.param("G70\nG0 X400\nG0 X1 Y1\nG0 X400", "mm", [], [1], id="perhaps inches"),
        pytest.param("G0 X400\nG70 G0 X400\nG71\nX400", "mm", [1], [2], id="places before them are certain"),
        pytest.param("G71\nG0 X400", "mm", [2], [], id="millimetres either way"),
        pytest.param("G70 G0 X12", "inch", [1], [], id="inches either way"),
        pytest.param("G71 G0 X400", "inch", [], [1], id="perhaps millimetres"),
        pytest.param("G70\nG0 X1 A400", "mm", [2], [1], id="degrees are none of them"),
    ],
)
def test_a_code_that_may_set_the_unit(dialect: str, text: str, unit: str, lines: list[int], unsaid: list[int]) -> None:
    machine = {"limits": {**LIMITS["limits"], "A": [0, 360]}, "unit": unit, "spindle": False}
    language, head = by_name(dialect), "(P)\n" if dialect == "z32" else ""
    program = Document.parse(f"{head}{text}\nM30\n", language)
    asides = list[Aside]()
    found = ran(Analysis(program, RuleSet(language, machine=machine), "main", MemoryHost({})), aside=asides.append)
    shift = len(head) // 4
    assert [each.place.line + 1 - shift for each in found if each.rule.endswith("outside-limits")] == lines
    assert [each.line + 1 - shift for each in asides if "may set the unit" in each.why] == unsaid


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        pytest.param("G0 Z1\nG0 Z5", [1], id="down"),
        pytest.param("G0 Z5\nG1 Z-2 F9\nG0 X5\nG0 Z5", [3], id="sideways"),
        pytest.param("G0 Z5\nG1 Z-2 F9\nG0 Z-1\nG0 Z5", [], id="straight out"),
        pytest.param("G0 Z5\nG1 Z-2 F9\nG0 X5 Z9", [3], id="slanting out"),
        pytest.param("G0 Z5\nG98 G83 X1 Y1 Z-9 R1 Q2 F9\nX2\nG80", [], id="the rapids of a cycle in its hole"),
        pytest.param("G0 Z5\nG99 G81 X1 Y1 Z-9 R1 F9\nX2\nG80", [3], id="a cycle that goes to its next hole low"),
        pytest.param("G0 X1\nG28\nG0 X2", [], id="a height that nobody said"),
    ],
)
def test_what_is_too_low(text: str, lines: list[int]) -> None:
    for spindle in ("M3 S1", "M5"):
        machine = {"z-safe": 2, "spindle": False}
        assert messages(f"{spindle}\n{text}\nM2", machine) == [f"{line + 1} rs274.rapid-below-safe" for line in lines]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("M3 S1\nG1 X1\nM5\nX2\nX3\nM4\nX4", [4]),
        ("M3 S1\nG1 X1\nT1 M6\nX2\nM3\nX3\nM6\nX4", [4, 8]),
        ("G0 X1\nG38.2 X5\nG1\nG2 X6 I1", [4]),
    ],
)
def test_cuts_without_a_spindle(text: str, lines: list[int]) -> None:
    told = [f"{line + 1} rs274.cut-without-spindle" for line in lines]
    assert messages(f"F100\n{text}\nM2", {"spindle": True}) == told
    assert messages(f"F100\n{text}\nM2", {"z-safe": -1000}) == told
    assert messages(f"F100\n{text}\nM2", {"spindle": False}) == []


@pytest.mark.parametrize("dialect", ["metagcode", "z32"])
def test_a_cut_without_feed(dialect: str) -> None:
    head = "(P)\n" if dialect == "z32" else ""
    found = said(dialect, f"{head}S1 M3\nG0 X1\nG1 X2\nX3\nG1 X4 F10\nM30\n", LIMITS)
    assert [(each.rule, each.place.line) for each in found] == [(f"{dialect}.cut-without-feed", 2 + len(head) // 4)]


def test_rs274_has_names_of_its_own_for_a_cut_without_feed() -> None:
    language = by_name("rs274")
    text = "o1 sub\nG94\no1 endsub\nM3 S1\nF100\no1 call\nG1 X1\nM2\n"
    analysis = Analysis(Document.parse(text, language), RuleSet(language, machine=LIMITS), "main", MemoryHost({}))
    assert [(found.rule, found.place.line) for found in ran(analysis)] == [("rs274.feed-missing", 6)]


PROGRAMS = [path for name in NAMES for path in sorted((ROOT / "examples" / name).iterdir()) if path.suffix in by_name(name).extensions]  # fmt: skip


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_nothing_is_said_of_an_example_without_a_machine(path: Path) -> None:
    assert said(path.parent.name, path.read_text(encoding="utf-8"), {}) == []
