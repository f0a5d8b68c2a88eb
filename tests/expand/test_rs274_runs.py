"""RS274: what a run meets, that it ends, and what it costs (spec/rs274.md §6 to §9, spec/oracle.md §4)."""

import re
import tracemalloc
from pathlib import Path

import pytest

import deburr.expand.rs274
from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, SourceMap, drive, expand
from deburr.expand.rs274.values import Values
from deburr.fault import Entered, Frame
from deburr.finding import Severity
from deburr.host import NoFiles
from deburr.ran import ran
from deburr.ruleset import RuleSet
from deburr_grammar.document import Document
from support.pages import MemoryHost
from support.rs274 import DIALECT, MAIN, RULES, expansion

SUB = "o1 sub\nG0 X1\no1 endsub\n"
MET = {
    "divide-by-zero 2 8-10": "#1=0\nG0 X[10/#1]\nM2\n",
    "domain 2 4-12": "#1=-1\nG0 XSQRT[#1]\nM2\n",
    "not-finite 2 4-12": "#1=0\nG0 X[3MOD#1]\nM2\n",
    "integer-required 2 5-12": "#1=0\nG0 X#[#1+.5]\nM2\n",
    "param-range 2 4-7": "#1=0\nG0 X##1\nM2\n",
    "param-readonly 2 0-3": "#1=5420\n##1=3\nM2\n",
    "named-undefined 4 4-8": "o1 if [#2]\n#<a>=1\no1 endif\nG0 X#<a>\nM2\n",
    "sub-unknown 2 0-8": "#1=9\no#1 call\nM2\n",
    "sub-unknown 4 0-6": "M98 P2\nG0 X1\nM2\no2 sub\no2 endsub\nO2\nG0 X3\nM99\n",
    "sub-unknown 1 0-6": "o2 sub\no2 endsub\no2 call\n#1=2\nM98 P#1\nM2\n",
    "sub-unknown 2 0-8 by a computed code": "#1=98\nM#1 P900\nM2\n",
    "arc-radius 4 4-6": "F9\n#1=4\nG91 G0 X#1\nG90 G2 X9 R1\nM2\n",
    "arc-radius 5 0-2": "G99 F9\n#1=4\nG81 X#1 Y0 Z-1 R1\nG80\nG2 X9 R1\nM2\n",
    "arc-radius 5 0-2 in inches": "G21 F9\n#1=25.4\nG0 X#1\nG20\nG2 X9 R1\nM2\n",
    "arc-radius 4 0-2 in diameters": "G7 G18 F9\n#1=20\nG0 X#1 Z0\nG2 X10 Z-3 I2 K-1\nM2\n",
    "probe-in-place 3 0-5": "F9\n#1=5\nG38.2 X[#1-5]\nM2\n",
    "sub-nested 2 0-2": "o1 sub\nO5\nG0 X1\nM99\no1 endsub\nM98 P5\nM2\n",
    "sub-nested 3 0-2 uncalled": "G0 X1\no1 sub\nO5\nM99\no1 endsub\nM2\n",
    "cycle-depth 4 3-6": "F9\n#1=1\nG81 X1 Z-1 R#1\nX2 R-3\nM2\n",
    "sub-redefined 5 0-11": f"{SUB}#1=1\no[#1+0] sub\no1 endsub\nM2\n",
    "sub-before-definition 3 0-6": "#1=1\no#1 call\no1 sub\no1 endsub\nM2\n",
    "sub-depth 3 0-14": "o1 sub\no2 if [#1 LT 99]\no1 call [#1+1]\no2 endif\no1 endsub\no1 call\nM2\n",
    "o-label-integer 2 1-7": "#1=1\no[#1/2] call\nM2\n",
    "abort 2 0-10": "#1=0\n(ABORT,#1)\nM2\n",
    "restore-unsaved 2 0-3": "o1 sub\nM72\no1 endsub\no1 call\nM2\n",
    "program-end-missing 2 0-0": "#5=3\nM#5\n\n",
    "program-end-missing 3 0-0": "o1 if [0]\nM2\no1 endif\n",
    "program-end-missing 6 0-0": "o<e> sub\no1 if [#1]\nM2\no1 endif\no<e> endsub\no<e> call [0]\n",
    "negative-value 3 6-10": "#1=2\nF100\nG1 X1 F-#1\nM2\n",
    "feed-missing 2 0-2": f"{SUB.replace('G0', 'G1')}o1 call\nM2\n",
    "feed-zero 2 0-2": "#1=0 F1\nG1 X1 F#1\nM2\n",
    "g-unknown 2 0-3": "#1=12\nG#1\nM2\n",
    "compare-near 2 7-14": "#1=0.00005\no1 if [#1 EQ 0]\no1 endif\nM2\n",
    "limit 1 0-12": "o1 while [1]\no1 endwhile\nM2\n",
}
"""Rule, row from 1, columns: the programs that meet it there."""


@pytest.mark.parametrize("expected", MET)
def test_what_a_run_meets(expected: str) -> None:
    kind, row, columns, *_ = expected.split()
    start, end = map(int, columns.split("-"))
    fault = expansion(MET[expected]).faults[-1]
    assert (fault.kind, fault.line + 1, fault.span.start, fault.span.end) == (kind, int(row), start, end), fault


ENDLESS = {
    "a condition that always holds": ("o1 while [1]\nG0 X1\no1 endwhile\nM2\n", "limit", "`o1 while [1]` never ends"),
    "a step of zero": ("#<x>=0 #<s>=0\no1 while [#<x> LT 9]\n#<x>=[#<x>+#<s>]\no1 endwhile\nM2\n", "limit", "`#<x>` = 0"),
    "a step too small": ("#1=0\no1 while [#1 LT 9]\n#1=[#1+0.00001]\no1 endwhile\nM2\n", "limit", "in `o1 while [#1 LT 9]` of line 2 in pass"),
    "do": ("#1=2\no1 do\nG0 X#1\no1 while [#1 GT 1]\nM2\n", "limit", "`#1` = 2"),
    "a count beyond all": ("o1 repeat [10**12]\nG91 G0 X1\no1 endrepeat\nM2\n", "limit", "in `o1 repeat [10**12]` of line 1 in pass"),
    "loops in loops": ("o1 while [1]\no2 repeat [3]\nG0 X1\no2 endrepeat\no1 endwhile\nM2\n", "limit", "`o1 while [1]` never ends"),
    "overlapping loops": ("o1 while [1]\no2 while [1]\no1 endwhile\no2 endwhile\nM2\n", "limit", "lines were executed"),
    "a sub that calls itself": ("o1 sub\no2 if [1]\no1 call\no2 endif\no1 endsub\no1 call\nM2\n", "sub-depth", "9 calls are active"),
    "two subs that call each other": ("o1 sub\no2 call\no1 endsub\no2 sub\no1 call\no2 endsub\no1 call\nM2\n", "sub-depth", "9 calls are active"),
    "a program that calls itself": ("M98 P5\nM2\no5\nM98 P5\nM99\n", "sub-depth", "9 calls are active"),
    "a program that is called too often": ("M98 P5 L1000000000\nM2\no5\nG0 X1\nM99\n", "limit", "lines were executed"),
    "motion without end": ("G91\no1 while [1]\n#1=#5420\nG0 X1\no1 endwhile\nM2\n", "limit", "in `o1 while [1]` of line 2 in pass"),
}  # fmt: skip


@pytest.mark.parametrize("name", ENDLESS)
def test_what_never_ends_ends_with_a_located_fault(name: str) -> None:
    program, kind, words = ENDLESS[name]
    tracemalloc.start()
    found = expansion(program, budget=Budget(20_000, 50_000))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    fault = found.faults[-1]
    assert (fault.kind, fault.file) == (kind, MAIN)
    assert words in fault.message, fault.message
    assert peak < 100_000_000


def test_a_budget_is_kept_to_the_line() -> None:
    program = "#1=0\no1 while [#1 LT 10]\n#1=[#1+1]\no1 endwhile\nM2\n"
    # One setting, eleven tests, ten times two lines, M2.
    assert not expansion(program, budget=Budget(33, 0)).faults
    assert expansion(program, budget=Budget(32, 0)).cut
    assert expansion(program, budget=Budget(31, 0)).cut


class _Counted:
    lines = 0

    def line(self, text: str) -> None:
        self.lines += 1


def test_memory_does_not_grow_with_what_is_written() -> None:
    program = "#1=0\no1 while [#1 LT 30000]\nG1 X#1 Y[#1/7] F100\n#1=[#1+1]\no1 endwhile\nM2\n"
    sink = _Counted()
    job = Job([Program(MAIN, Document.parse(program, DIALECT))], RULES, MemoryHost({}), sink, budget=Budget(0, 0))
    run = drive(job)
    peaks = []
    tracemalloc.start()
    for at, _ in enumerate(run):
        if at % 20 == 19:
            peaks.append(tracemalloc.get_traced_memory()[1])
    tracemalloc.stop()
    assert sink.lines == 30_001
    assert peaks[-1] < 12_000_000
    assert peaks[-1] - peaks[len(peaks) // 2] < 3_000_000


def test_a_map_is_written_in_pieces() -> None:
    kept = SourceMap()
    for row in range(50_000):
        kept.add(MAIN, row, Frame(None, MAIN, row % 7, Entered.LOOP, row))
    tracemalloc.start()
    longest = max(map(len, kept.texts("")))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert longest < 200_000
    assert peak < 2_000_000
    document = kept.document("flat.ngc")
    assert (len(document["x_deburr_lines"]), document["x_deburr_lines"][-1]) == (50_000, [0, 49_999, 49_999])
    assert (len(document["x_deburr_frames"]), document["x_deburr_frames"][8]) == (50_000, [-1, 0, 1, "loop", 8])
    assert document["mappings"].startswith("AAAA;AACA;AACA;") and document["mappings"].count(";") == 49_999


def test_plain_lines_are_copied_without_a_closure_for_each(monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[int] = []
    node = Document.node
    monkeypatch.setattr(Document, "node", lambda document, line: read.append(line) or node(document, line))
    moves = "".join(f"N{at} G1 X{at} Y{at / 7:.4f}\n" for at in range(3_000))
    found = expansion(f"G90 F100\n{moves}#1=#5421 #2=#<_motion_mode>\nG0 X#1 Y#2\nM2\n")
    assert found.lines[-2:] == ["G0 X428.4286 Y10", "M2"]
    assert len(found.lines) == 3_003
    assert len(set(read)) < 10


def test_lines_that_differ_in_numbers_are_compiled_once(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled: list[str] = []
    value = Values.value
    monkeypatch.setattr(Values, "value", lambda self, part: compiled.append(part.kind) or value(self, part))
    lines = "".join(f"N{at} G1 X[{at}+#1] Y-{at}.5 Z[#1*{at / 8}] (no {at})\n" for at in range(1_000))
    found = expansion(f"#1=.5 F100\n{lines}M2\n")
    assert found.lines[1:3] == ["G1 X0.5 Y-0.5 Z0 (no 0)", "G1 X1.5 Y-1.5 Z0.0625 (no 1)"]
    assert found.lines[1_000] == "G1 X999.5 Y-999.5 Z62.4375 (no 999)"
    assert len(compiled) < 30


SHARED = {
    "numbers of parameters": ("#1=[1+1]\n#2=[1+2]\nG0 X[#1*10]\nG0 X[#2*10]", ["G0 X20", "G0 X30"]),
    "digits in names": ("#<a1>=[1]\n#<a2>=[2]\nG0 X[#<a1>*3]\nG0 X[#<a2>*4]", ["G0 X3", "G0 X8"]),
    "blanks in numbers": ("#1=1\nG0 X[1 2+#1] Y 3\nG0 X[3 4+#1] Y 5 6", ["G0 X13 Y 3", "G0 X35 Y 5 6"]),
    "comments of other lengths": ("#1=1\nG0 X[2+#1] (33)\nG0 X[44+#1] (5) ;666", ["G0 X3 (33)", "G0 X45 (5) ;666"]),
    "signs": ("#1=1\nG0 X-[2+#1] Y--3\nG0 X-[20+#1] Y--30", ["G0 X-3 Y--3", "G0 X-21 Y--30"]),
    "codes are no arguments": ("#1=1\nG0 X#1 F2\nG1 X#1 F3", ["G0 X1 F2", "G1 X1 F3"]),
    "points": ("#1=1\nG0 X[.5+#1] Y1. Z.5\nG0 X[.25+#1] Y10. Z.125", ["G0 X1.5 Y1. Z.5", "G0 X1.25 Y10. Z.125"]),
    "the same line again": ("#1=1\no1 while [#1 LT 4]\nG0 X[2*#1]\nG0 X[30*#1]\n#1=[#1+1]\no1 endwhile",
                            ["G0 X2", "G0 X30", "G0 X4", "G0 X60", "G0 X6", "G0 X90"]),
}  # fmt: skip


@pytest.mark.parametrize("name", SHARED)
def test_what_lines_of_one_shape_share_and_what_not(name: str) -> None:
    program, lines = SHARED[name]
    assert expansion(f"{program}\nM2\n").lines == [*lines, "M2"]


def test_a_fault_of_a_shared_line_is_at_its_own_columns() -> None:
    fault = expansion("#1=0\nG0 X[5+#1]\nG0 X[5/[1+#1]]\nG0 X[1234/[0+#1]] (x)\nM2\n").faults[-1]
    assert (fault.line, fault.span, "`1234/[0+#1]`" in fault.message) == (3, (10, 16), True)


FOLLOWED = {
    "the last of each letter": ("G1 X1 Y2 F7\nX3\n(a)\nZ4 F9", (3, 2, 4, 9, 10)),
    "motion of an earlier line": ("G2 X3 Y4 I1.5 J2\nG1\nX5", (5, 4, 0, 5, 10)),
    "increments": ("X1\nG91\nX1\nX1\nG90\nY2", (3, 2, 0, 5, 10)),
    "a cycle between moves": ("X1\nG81 X4 Z-2 R3\nX5\nG0 Y6", (5, 6, 3, 5, 0)),
    "an offset": ("X1\nG92 X10\nX12", (12, 0, 0, 5, 10)),
    "comments between words": ("X1 (2) Y3\nG1 (4) Z5 (6)", (1, 3, 5, 5, 10)),
    "signs, blanks and names of axes": ("x - 1 2 y--.5\nG 1 Z+3.", (-12, 0.5, 3, 5, 10)),
    "inches": ("G20\nX1\nG21\nY1", (25.4, 1, 0, 5, 10)),
    "a diameter": ("G7\nX10\nG8\nZ2", (5, 0, 2, 5, 10)),
    "another system": ("G10 L2 P2 X10\nX1\nG55\nY3\nX4", (4, 3, 0, 5, 10)),
    "machine coordinates": ("G10 L2 P1 X10\nG53 G1 X4\nY3", (-6, 3, 0, 5, 10)),
}


@pytest.mark.parametrize("name", FOLLOWED)
def test_copied_lines_are_followed(name: str) -> None:
    program, (x, y, z, feed, motion) = FOLLOWED[name]
    ask = "G0 X#5420 Y#5421 Z#5422 S#<_feed> (PRINT,#<_motion_mode>)"
    found = expansion(f"G90 G1 F5\n{program}\n{ask}\nM2\n")
    assert not found.faults
    assert found.lines[-2] == f"G0 X{x} Y{y} Z{z} S{feed} (PRINT,{motion:.6f})"


def test_a_loop_reads_its_lines_once(monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[int] = []
    node = Document.node
    monkeypatch.setattr(Document, "node", lambda document, line: read.append(line) or node(document, line))
    expansion("#1=0\no1 while [#1 LT 500]\nG1 X#1 F9\n#1=[#1+1]\no1 endwhile\nM2\n")
    assert max(map(read.count, read)) < 5


LEAKS = {
    "break-leaks 7 0-18": "o1 while [1]\no1 break\no1 endwhile\n#1=0\no5 do\n#1=[#1+1]\no5 while [#1 LT 3]\nM2\n",
    "break-leaks 9 0-18": "#1=0\no5 do\n#1=[#1+1]\no1 while [0]\no2 if [#1]\no1 break\no2 endif\no1 endwhile\no5 while [#1 LT 3]\nM2\n",
    "continue-leaks 7 0-12": "#1=0\no1 do\n#1=[#1+1]\no1 continue\no1 while [#1 LT 3]\no5 repeat [2]\no5 endrepeat\nM2\n",
    "repeat-counter 2 0-13": "o1 sub\no2 repeat [3]\no3 if [#1 EQ 1]\no1 return\no3 endif\no2 endrepeat\no1 endsub\no1 call [1]\no1 call [2]\nM2\n",
}


@pytest.mark.parametrize("expected", LEAKS)
def test_faults_of_the_interpreter_are_named_and_not_imitated(expected: str) -> None:
    found = expansion(LEAKS[expected])
    kind, row, columns = expected.split()
    told = {(fault.kind, fault.line + 1, f"{fault.span.start}-{fault.span.end}") for fault in found.faults}
    assert (kind, int(row), columns) in told, told
    assert found.lines[-1] == "M2"


IN_THE_CALLER = {
    "o#<n> call [5]": ["G0 X5"],
    "o[#<n>] call [#<n>]": ["G0 X100"],
    "M98 P#<n>": ["G0 X7"],
    "M98 P[#<n>] L[#<n>/50]": ["G0 X7", "G0 X7"],
}
"""Calls whose label or number the caller's own name tells, and what they run."""


@pytest.mark.parametrize("call", IN_THE_CALLER)
def test_whom_a_call_means_is_read_before_it_is_active(call: str) -> None:
    numbered = call.startswith("M98")
    callee = "o100\nG0 X7\nM99\n" if numbered else "o100 sub\nG0 X#1\no100 endsub\n"
    inside = f"o200 sub\n#<n>=100\n{call}\no200 endsub\no200 call\nM2\n{callee if numbered else ''}"
    outside = f"#<n>=100\n{call}\nM2\n{callee if numbered else ''}"
    for program in (outside, inside) if numbered else (callee + outside, callee + inside):
        found = expansion(program)
        assert (found.faults, found.lines) == ((), [*IN_THE_CALLER[call], "M2"])


FILES = {
    "lib.ngc": "o<lib> sub\nG1 X[1/#1] F100\no<lib> endsub\n",
    "bad.ngc": "o<bad> sub\nG0 X1 X2\no<bad> endsub\n",
    "other.ngc": "o<else> sub\no<else> endsub\n",
}


def test_a_fault_in_a_called_file_is_placed_there() -> None:
    found = expansion("o<lib> call [2]\no<lib> call [0]\nM2\n", FILES)
    fault = found.faults[-1]
    assert (fault.kind, fault.file, fault.line) == ("divide-by-zero", "lib.ngc", 1)
    assert fault.stack is not None
    assert [(frame.file, frame.row, frame.number) for frame in fault.stack.outward()] == [(MAIN, 1, 1)]
    assert found.lines == ["G1 X0.5 F100"]


def test_a_called_file_that_is_wrong_stops_the_run() -> None:
    fault = expansion("#1=1\no<bad> call\nM2\n", FILES).faults[-1]
    assert (fault.kind, fault.file, fault.line) == ("word-repeated", "bad.ngc", 1)
    fault = expansion("o<other> call\nM2\n", FILES).faults[-1]
    assert (fault.kind, fault.file, fault.line) == ("sub-file", MAIN, 0)


def test_a_check_follows_saved_modes_that_are_thrown_away() -> None:
    for program, found in (("M73\nG91\nM71\nG90 M72\nM2\n", [(3, 4, 7)]), ("M73\nG91\nM71\nM70\nM72\nM2\n", [])):
        findings = Analysis(Document.parse(program, DIALECT), RULES, MAIN, MemoryHost({}), (), ran).findings()
        told = [(each.place.line, each.place.col, each.place.end_col) for each in findings]
        assert ({each.rule for each in findings}, told) == ({"rs274.restore-unsaved"} if found else set(), found)


@pytest.mark.parametrize("call", ["o<none> call", "M98 P9"])
def test_without_a_folder_no_subprogram_is_missing(call: str) -> None:
    document = Document.parse(f"{call}\nM2\n", DIALECT)
    (fault,) = expand([Program(MAIN, document)], RULES, NoFiles()).faults
    assert (fault.kind, fault.line, fault.input) == ("sub-unknown", 0, True)
    for host, found in ((NoFiles(), []), (MemoryHost({MAIN: ""}), ["rs274.sub-unknown"])):
        for run in (ran, None):
            findings = Analysis(document, RULES, MAIN, host, (), run).findings()
            assert [each.rule for each in findings if each.severity is Severity.ERROR] == found


def test_a_program_that_its_file_does_not_have_is_sought_nowhere_else() -> None:
    fault = expansion("M98 P2\nM30\nO2\nM99\n", {"2.ngc": "G0 X1\nM2\n"}).faults[-1]
    assert (fault.kind, fault.line, fault.message.split(",")[0]) == ("sub-file", 0, "`2.ngc` has no program `O2`")


@pytest.mark.parametrize(
    "program",
    [
        "#5=2\nM#5\n(x)\n",
        "o1 repeat [2]\n#5=[#5+15] M#5\no1 endrepeat\n",
        "#5=3\nM#5\nM2\n",
        "%\n#5=3\nM#5\n%\n",
        "#5=3\nM#5\n/M2\n",
        "o<e> sub\no1 if [#1]\nM2\no1 endif\no<e> endsub\n",
        "(not_a_subfile)\n#1=5\nG0 X#1\n",
    ],
)
def test_a_program_with_a_computed_m_code_may_end(program: str) -> None:
    assert "program-end-missing" not in {fault.kind for fault in expansion(program).faults}


INPUT = {
    "runtime-value": "G38.2 Z-5 F10\nG0 X#5061\nM2\n",
    "block-delete-state": "/#1=5\nG0 X#1\nM2\n",
}


@pytest.mark.parametrize("kind", INPUT)
def test_what_only_an_input_decides_is_no_finding_of_a_check(kind: str) -> None:
    program = INPUT[kind]
    assert [fault.kind for fault in expansion(program).faults] == [kind]
    findings = Analysis(Document.parse(program, DIALECT), RULES, MAIN, MemoryHost({}), (), ran).findings()
    assert [finding for finding in findings if finding.severity is Severity.ERROR] == []


def test_simulated_values_and_the_switch_let_the_run_go_on() -> None:
    inputs = Inputs(simulate=True, block_delete=False)
    assert expansion("G38.2 Z-5 F10\nG0 Z#5063\nM66 P1 L0\n/#1=#5399\nG0 X#1\nM2\n", inputs=inputs).lines == [
        "G38.2 Z-5 F10", "G0 Z-5", "M66 P1 L0", "G0 X0", "M2",
    ]  # fmt: skip


def test_a_rule_that_is_off_or_allowed_does_not_stop_a_run() -> None:
    program = "#1=2\n(deburr: allow rs274.negative-value)\nS-#1\nM2\n"
    assert expansion(program).lines[-1] == "M2"
    softer = RuleSet(DIALECT, {}, severities={"rs274.negative-value": Severity.WARNING})
    assert not expansion("#1=2\nS-#1\nM2\n", rules=softer).faults
    assert expansion("#1=2\nS-#1\nM2\n").faults


def test_every_fault_has_its_rule() -> None:
    folder = Path(deburr.expand.rs274.__file__).parent
    texts = [path.read_text(encoding="utf-8") for path in folder.glob("*.py")]
    kinds = {kind for text in texts for kind in re.findall(r'(?:fault|warn|halt|Fault)\(\s*"([a-z0-9-]+)"', text)}
    assert len(kinds) > 20
    assert [kind for kind in sorted(kinds) if RULES.named(kind) is None] == []
