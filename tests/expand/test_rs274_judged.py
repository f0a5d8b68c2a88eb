"""RS274: what a run knows of modal state where the text of a program tells nothing of it: behind calls, and saved modes (spec/rs274.md §5, §6)."""

import pytest

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.ran import ran
from deburr_grammar.document import Document
from support.pages import MemoryHost
from support.rs274 import DIALECT, MAIN, RULES, expansion

O900 = "M2\nO900\nG4 P1\nM99\n"
SAVES = "o<s> sub\nM73\nG91\no<s> endsub\n"
REFUSED = {
    "feed-missing 2 0-2": f"M98 P900\nG1 X5\n{O900}",
    "axis-no-motion 2 0-2": f"M98 P900\nX5\n{O900}",
    "cycle-word 3 0-3": f"F10\nM98 P900\nG81 X1\n{O900}",
    "g53 3 0-3": f"G91\nM98 P900\nG53 G0 Z0\n{O900}",
    "arc-form 4 9-11": f"F10\nG18\nM98 P900\nG2 X1 Y1 J1\n{O900}",
    "arc-radius 3 0-2": f"F10\nM98 P900\nG2 X1 Y1 I0.3 J0\n{O900}",
    "in-compensation 3 0-5": f"G41.1 D1\nM98 P900\nG41.1 D1\n{O900}",
    "feed-missing 4 0-2 from 1": "M98 P900\nM2\nO900\nG1 X5\nM99\n",
    "axis-no-motion 4 0-2 from 1": "M98 P900\nM2\nO900\nX5\nM99\n",
    "g53 3 0-3 behind M73": "G91\nM73\nG53 G0 Z0\nM2\n",
    "feed-missing 2 0-2 behind M73": "M73\nG1 X5\nM2\n",
    "axis-no-motion 5 0-2 behind M72": "G0 X0\nM70\nG80\nM72\nX1\nM2\n",
    "feed-zero 4 0-2 behind M72": "M70\nF100\nM72\nG1 X5\nM2\n",
    "feed-missing 5 0-2 behind M72": "F100\nM70\nG93\nM72\nG1 X5\nM2\n",
    "arc-radius 6 0-2 behind M72": "F100\nG0 X0 Y0\nM70\nG91\nM72\nG2 X1 Y1 I0.3 J0\nM2\n",
    "feed-missing 4 0-2 from 6": "o<s> sub\nM73\nG91\nG1 X5\no<s> endsub\no<s> call\nM2\n",
    "feed-missing 6 0-2 behind a call": f"{SAVES}o<s> call\nG1 X5\nM2\n",
    "g53 7 0-3 behind a call": f"{SAVES}G91\no<s> call\nG53 G0 X5\nM2\n",
}
"""Rule, row from 1, columns, and the row of the call: programs that the control refuses there."""


@pytest.mark.parametrize("expected", REFUSED)
def test_what_is_refused_is_found_behind_calls_and_saved_modes(expected: str) -> None:
    program = REFUSED[expected]
    kind, row, columns, *more = expected.split()
    start, end = map(int, columns.split("-"))
    calls = [int(more[1])] if more[:1] == ["from"] else []
    (fault,) = expansion(program).faults
    assert (fault.kind, fault.line + 1, *fault.span) == (kind, int(row), start, end)
    assert [frame.row + 1 for frame in (fault.stack.outward() if fault.stack else ())] == calls
    findings = Analysis(Document.parse(program, DIALECT), RULES, MAIN, MemoryHost({}), (), ran).findings()
    (found,) = [finding for finding in findings if finding.severity is Severity.ERROR]
    assert (found.rule, found.place.line + 1, found.place.col, found.place.end_col) == (
        f"rs274.{kind}",
        int(row),
        start,
        end,
    )
    assert [related.place.line + 1 for related in found.related] == calls


RUNS = {
    "the end of a call brings G90 back": f"{SAVES}o<s> call\nG53 G0 X5\nM2\n",
    "M72 brings the feed back": "F100\nM70\nF50\nM72\nG1 X5\nM2\n",
    "M72 brings the plane back": "F10\nG18\nM70\nG17\nM72\nG2 X2 K0 I1\nM2\n",
    "M72 ends compensation": "M70\nG41.1 D1\nM72\nG41.1 D1\nG40\nM2\n",
    "a feed from the program that was called": "M98 P900\nG1 X5\nM2\nO900\nF10\nM99\n",
    "each pass brings its modes back": "M98 P900 L2\nM2\nO900\nM73\nG41.1 D1\nM99\n",
}


@pytest.mark.parametrize("name", RUNS)
def test_what_the_control_runs_is_not_refused(name: str) -> None:
    program = RUNS[name]
    assert not expansion(program).faults
    findings = Analysis(Document.parse(program, DIALECT), RULES, MAIN, MemoryHost({}), (), ran).findings()
    assert [finding for finding in findings if finding.severity is Severity.ERROR] == []


BROUGHT_BACK = {
    "by each pass of M98": ("M98 P900 L2\nM2\nO900\nM73\nG91\nM99\n", ["M70", "G91", "M72", "M70", "G91", "M72", "M2"]),
    "by a pass of its own": ("M98 P900 L2\nM2\nO900\n#1=[#1+1]\no1 if [#1 EQ 1]\nM73\no1 else\nM70\no1 endif\nG91\nM99\n",
                             ["M70", "G91", "M72", "M70", "G91", "M2"]),
    "after M70 behind M73": ("o1 sub\nM73\nM70\nG91\no1 endsub\no1 call\nM2\n", ["M70", "M70", "G91", "M72", "M2"]),
    "after M71 and M70 behind M73": ("o1 sub\nM73\nM71\nM70\nG91\no1 endsub\no1 call\nM2\n", ["M70", "M70", "G91", "M72", "M2"]),
    "not after M71 behind M73": ("o1 sub\nM73\nM71\nG91\no1 endsub\no1 call\nM2\n", ["M70", "G91", "M2"]),
}  # fmt: skip


@pytest.mark.parametrize("name", BROUGHT_BACK)
def test_the_end_of_what_was_called_brings_back(name: str) -> None:
    program, lines = BROUGHT_BACK[name]
    assert expansion(program).lines == lines
