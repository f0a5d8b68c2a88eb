"""RS274: what is proven at each line, that it holds in runs, and what an edit costs (spec/rs274.md §3, §4, §6)."""

from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.needs import Needs
from deburr.ruleset import RuleSet
from deburr.values import passes_at, proving, values_of
from deburr.values.domain import exactly
from deburr.values.graph import Graph, Key
from deburr.values.solve import Solution
from deburr.values.words import said
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost
from support.values import MAIN, analysed, known

FRAME = "G21 G90 G17 F100\n"
MEANT: dict[str, tuple[str, int, Key, str]] = {
    "a constant": ("#3=[2*5]\nG0 X#3\n", 2, 3, "10"),
    "what the machine knows": ("#3=#5420\nG0 X#3\n", 2, 3, ""),
    "a loop that counts up": ("#3=0\no1 while [#3 LT 100]\nG0 X#3\n#3=[#3+10]\no1 endwhile\n", 3, 3, "0 … 90 step 10"),
    "behind a loop that counts up": ("#3=0\no1 while [#3 LT 100]\n#3=[#3+10]\no1 endwhile\nG0 X#3\n", 5, 3, "100"),
    "a loop that counts down by tenths": ("#3=0\no1 while [#3 GT -1]\n#3=[#3-0.1]\nG0 Z#3\no1 endwhile\n", 4, 3, "-1.1 … -0.1"),
    "a loop in a loop": (
        "#3=0\no1 while [#3 LT 3]\n#4=8\no2 while [#4 GT 0]\nG0 X#3 Y#4\n#4=[#4-2]\no2 endwhile\n#3=[#3+1]\no1 endwhile\n",
        5, 4, "2 … 8 step 2",
    ),
    "the outer one in the inner one": (
        "#3=0\no1 while [#3 LT 3]\n#4=8\no2 while [#4 GT 0]\nG0 X#3 Y#4\n#4=[#4-2]\no2 endwhile\n#3=[#3+1]\no1 endwhile\n",
        5, 3, "0 … 2, integers",
    ),
    "a repeated sum": ("#3=0\no1 repeat [4]\n#3=[#3+2]\no1 endrepeat\nG0 X#3\n", 5, 3, "at least 2"),
    "a branch": ("o1 if [#5420 GT 0]\n#3=1\no1 else\n#3=4\no1 endif\nG0 X#3\n", 6, 3, "1 … 4 step 3"),
    "a condition": ("#3=#5420\no1 if [#3 GT 2]\nG0 X#3\no1 endif\n", 3, 3, "above 2"),
    "a condition that does not hold": ("#3=#5420\no1 if [#3 GT 2]\no1 else\nG0 X#3\no1 endif\n", 4, 3, "at most 2"),
    "two conditions at once": ("#3=#5420\no1 if [[#3 GT 2] AND [#3 LE 9]]\nG0 X#3\no1 endif\n", 3, 3, "2 … 9"),
    "that it is not 0": ("#3=#5420\no1 if [#3 NE 0]\nG0 X#3\no1 endif\n", 3, 3, "never 0"),
    "that it is an integer": ("#3=FIX[#5420]\no1 if [[#3 GT 2] AND [#3 LT 9]]\nG0 X#3\no1 endif\n", 3, 3, "3 … 8, integers"),
    "a remainder": ("#3=[FIX[#5420] MOD 6]\nG0 X#3\n", 2, 3, "0 … 5, integers"),
    "a sine": ("#3=[SIN[#5420]*20]\nG0 X#3\n", 2, 3, "-20 … 20"),
    "a name without a value": ("G0 X#5420\n#<b>=1\n", 2, "b", "not set"),
    "a name that one way sets": ("o1 if [#5420 GT 0]\n#<b>=1\no1 endif\nG0 X#5420\n#<b>=2\n", 5, "b", "1, or not set"),
    "an argument of all calls": ("o<s> sub\nG0 X#1\no<s> endsub\no<s> call [3]\no<s> call [5]\n", 2, 1, "3 … 5 step 2"),
    "an argument that none gives": ("o<s> sub\nG0 X#2\no<s> endsub\no<s> call [3]\n", 2, 2, "0"),
    "what a subprogram sets": ("o<s> sub\n#100=[#1+1]\no<s> endsub\n#100=0\no<s> call [3]\nG0 X#100\n", 6, 100, "4"),
    "what a subprogram leaves alone": ("o<s> sub\n#100=#1\no<s> endsub\n#101=7\n#1=9\no<s> call [3]\nG0 X#101 Y#1\n", 7, 1, "9"),
    "one of several that is set by a computed number": ("#31=1\n#32=5\n#[31+[FIX[#5420] MOD 2]]=3\nG0 X#31 Y#32\n", 4, 32, "3 … 5 step 2"),
    "what nobody can see sets": ("#100=1\no<elsewhere> call\nG0 X#100\n", 3, 100, ""),
    "what a program shares with one that M98 calls": ("#1=5\nM98 P700\nG0 X#1\nM2\no700\n#1=6\nM99\n", 3, 1, ""),
    "a name that one that M98 calls cannot see": ("#<a>=5\nM98 P700\nG0 X#<a>\nM2\no700\n#1=6\nM99\n", 3, "a", "5"),
    "inside a program that M98 calls": ("M98 P700\nM2\no700\n#3=6\nG0 X#3\nM99\n", 5, 3, "6"),
    "what M98 calls may go on behind it": ("#3=5\no700\nG0 X#3\nM99\n", 3, 3, ""),
    "an argument that M98 shares with a subprogram": ("o1 sub\nG0 X#1\no1 endsub\no1 call [3]\nM98 P1\n", 2, 1, ""),
    "what the subprogram of a contour may set": ("#100=5\nG70 Q1\nG0 X#100\n", 3, 100, ""),
}  # fmt: skip
"""A program behind its frame, a line of it from 1, a parameter, and what it holds before that line."""


SUBS_OF_FILES = {
    "adds.ngc": "o<adds> sub\no<sets> call [#1+1]\no<adds> endsub\n",
    "sets.ngc": "(a file of its own)\no<sets> sub\n#100=#1\no<sets> endsub\n",
    "goes.ngc": "o<goes> sub\no<both> call [1]\no<goes> endsub\no<both> sub\n#100=#1\no<both> endsub\n",
    "torn.ngc": "o<torn> sub\no1 if [#1]\no<torn> endsub\n",
    "counts.ngc": "o<counts> sub\nM98 P9\no<counts> endsub\no9\n#100=9\nM99\n",
}
FILES: dict[str, tuple[str, int, Key, str]] = {
    "what a file sets that another one calls": ("o<adds> call [4]\nG0 X#100\n", 2, 100, "5"),
    "what it leaves alone": ("#101=7\no<adds> call [4]\nG0 X#101\n", 3, 101, "7"),
    "a file behind whose subprogram stands another one": ("o<goes> call\nG0 X#100\n", 2, 100, "1"),
    "a subprogram of which there are two": ("o<both> sub\n#100=3\no<both> endsub\no<goes> call\nG0 X#100\n", 5, 100, ""),
    "a file that cannot be read": ("#100=1\no<torn> call\nG0 X#100\n", 3, 100, ""),
    "a file that calls by numbers": ("#100=1\no<counts> call\nG0 X#100\n", 3, 100, ""),
    "a subprogram of which there is a file, too": ("o<sets> sub\n#100=3\no<sets> endsub\no<sets> call\nG0 X#100\n", 5, 100, ""),
}  # fmt: skip
"""As `MEANT`, beside these files."""


@pytest.mark.parametrize("name", FILES)
def test_what_called_files_do(name: str) -> None:
    program, line, key, text = FILES[name]
    found = known(analysed(f"{FRAME}{program}M2\n", "rs274", SUBS_OF_FILES))
    assert found is not None
    value = found.before[line].get(key)
    assert (said(value) if value is not None else "") == text, value


DIVIDES = {"part.ngc": "o<part> sub\nG0 X[5/#1]\no<part> endsub\nM2\n"}


def test_a_fault_in_a_called_file_is_found_from_the_program_that_calls_it() -> None:
    """A run need not come to it: the call stands under a condition that only the machine decides."""
    program = "o1 if [#5420 GT 5]\no<part> call [0]\no1 endif\nM2\n"
    (found,) = (each for each in proving(analysed(FRAME + program, "rs274", DIVIDES)) if each is not None)
    assert (found.rule, *found.place) == ("rs274.divide-by-zero", "part.ngc", 1, 7, 1, 9)
    assert [(each.place.file, each.place.line, each.message) for each in found.related] == [(MAIN, 2, "called here")]


def test_a_called_file_that_is_right_for_one_call_is_not_wrong() -> None:
    program = "o1 if [#5420 GT 5]\no<part> call [0]\no1 endif\no<part> call [2]\nM2\n"
    assert [each for each in proving(analysed(FRAME + program, "rs274", DIVIDES)) if each is not None] == []


def test_a_comment_in_a_called_file_allows_what_is_wrong_there() -> None:
    program = f"{FRAME}o1 if [#5420 GT 5]\no<part> call [0]\no1 endif\nM2\n"
    text = DIVIDES["part.ngc"].replace("#1]", "#1] (deburr: allow rs274.divide-by-zero)")
    for files, rules in ((DIVIDES, ["rs274.divide-by-zero"]), ({"part.ngc": text}, [])):
        language = by_name("rs274")
        document = Document.parse(program, language)
        analysis = Analysis(document, RuleSet(language), MAIN, MemoryHost(files), prove=proving)
        assert [each.rule for each in analysis.findings()] == rules


def test_a_check_hears_of_the_files_that_it_entered() -> None:
    analysis = analysed(f"{FRAME}o<adds> call [4]\nG0 X#100\nM2\n", "rs274", SUBS_OF_FILES)
    needs = analysis.host = Needs(analysis.host)
    assert values_of(analysis) is not None
    assert {"adds.ngc", "sets.ngc"} <= {path for path, text in needs.texts.items() if text is not None}


@pytest.mark.parametrize("written", ["M428", "m 0 4 28", "M428 P1"])
def test_a_code_of_the_machines_own_may_set_anything(written: str) -> None:
    ruleset = RuleSet(by_name("rs274"), {"remap": ("M428",)})
    document = Document.parse(f"{FRAME}#100=1\n#<a>=2\n{written}\nG0 X#100 Y#<a>\nM2\n", by_name("rs274"))
    found = known(Analysis(document, ruleset, MAIN))
    assert found is not None
    assert found.before[3] == {100: exactly(1.0), "a": exactly(2.0)} and found.before[4] == {}


@pytest.mark.parametrize("name", MEANT)
def test_what_a_parameter_holds(name: str) -> None:
    program, line, key, text = MEANT[name]
    found = known(analysed(f"{FRAME}{program}M2\n", "rs274"))
    assert found is not None
    value = found.before[line].get(key)
    assert (said(value) if value is not None else "") == text, value


SILENT = {
    "behind a computed M code, which may end the program": "#1=0 #2=2\nM#2\n#3=[1/#1]\n",
    "behind a computed M code, of a name that no call can reach": "#<a>=0 #2=2\nM#2\n#3=[1/#<a>]\n",
    "behind an M code that is calculated from numbers": "#1=0\nM[1+1]\n#3=[1/#1]\n",
    "a value that only the machine knows": "#3=#5420\nG0 X[5/#3]\n",
    "one way of two": "o1 if [#5420 GT 0]\n#3=0\no1 else\n#3=1\no1 endif\nG0 X[5/#3]\n",
    "a loop that an input ends": "o1 while [#5399 EQ 0]\nM66 P1 L0\no1 endwhile\n",
    "a loop that is left": "#3=0\no1 while [1]\n#3=[#3+1]\no2 if [#3 GT 5]\no1 break\no2 endif\no1 endwhile\n",
    "a loop in which the program ends": "#3=0\no1 while [1]\n#3=[#3+1]\no2 if [#3 GT 5]\nM30\no2 endif\no1 endwhile\n",
    "a loop that stops with a message": "#3=1\no1 while [#3 GT 0]\no2 if [#5420 GT 5]\n(ABORT, at the end)\no2 endif\no1 endwhile\n",
    "a loop whose call may end it": "o<s> sub\nM2\no<s> endsub\no1 while [1]\no<s> call\no1 endwhile\n",
    "a loop that runs out of parameters": "#3=100\no1 while [#3 GT 0]\n#[#3]=1\n#3=[#3+1]\no1 endwhile\n",
    "a division that is never reached": "#3=0\no1 if [#3 GT 0]\nG0 X[5/#3]\no1 endif\n",
    "a line that the operator may leave out": "#3=5\n/#3=0\nG0 X[5/#3]\n",
    "a name for which EXISTS asks": "o1 if [EXISTS[#<b>]]\n#<c>=1\no1 endif\n#<b>=2\n",
    "what is read where EXISTS holds": "o<s> sub\no2 if [EXISTS[#<a>]]\nG0 X#<a>\no2 endif\n#<a>=2\no<s> endsub\no<s> call\no<s> call\n",
    "what EXISTS found, kept in a parameter": "o<s> sub\n#<h>=EXISTS[#<a>]\no2 if [#<h> EQ 1]\nG0 X#<a>\no2 endif\no<s> endsub\no<s> call\n",
    "what a file of stored parameters may hold": "G0 X[5/#100]\n",
    "an argument of one call of two": "o<s> sub\nG0 X[5/#1]\no<s> endsub\no1 if [#5420 GT 0]\no<s> call [0]\no1 endif\no<s> call [1]\n",
}  # fmt: skip


@pytest.mark.parametrize("name", SILENT)
def test_nothing_is_said_of_what_is_not_proven(name: str) -> None:
    found = [each for each in proving(analysed(f"{FRAME}{SILENT[name]}M2\n", "rs274")) if each is not None]
    assert found == []


def test_the_chain_is_told() -> None:
    program = "o<s> sub\n#3=[#1-10]\nG0 X[5/#3]\no<s> endsub\nG0 X#5420\no<s> call [10]\nM2\n"
    found = next(each for each in proving(analysed(FRAME + program, "rs274")) if each is not None)
    assert [(each.place.line, each.message) for each in found.related] == [
        (2, "`#3` is set here, it holds 0"),
        (6, "called here"),
    ]


def test_conditions_are_part_of_the_chain() -> None:
    program = "#3=#5420\no1 if [#3 GE 6]\nG0 X[SQRT[5-#3]]\no1 endif\nM2\n"
    found = next(each for each in proving(analysed(FRAME + program, "rs274")) if each is not None)
    assert [(each.place.line, each.message) for each in found.related] == [
        (2, "from here on `#3`, it holds at least 6"),
        (1, "`#3` is set here"),
    ]


SUBS = "".join(
    f"o<{name}> sub\n#{at}=#1\no1 while [#{at} LT 9]\n#{at}=[#{at}+1]\nG0 X#{at}\no1 endwhile\no<{name}> endsub\n"
    for at, name in enumerate("abcd", 101)
)
CALLS = "".join(f"o<{name}> call [3]\n" for name in "abcd")


def _gone_through(text: str, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many nodes each routine has that is gone through."""
    made: list[int] = []

    class Counted(Solution):
        def __init__(self, graph: Graph, *more: Any) -> None:
            made.append(len(graph.nodes))
            super().__init__(graph, *more)

    with monkeypatch.context() as patch:
        patch.setattr("deburr.values.ledger.Solution", Counted)
        assert values_of(analysed(text, "rs274")) is not None
    return made


def test_an_edit_costs_the_routine_that_it_touches(monkeypatch: pytest.MonkeyPatch) -> None:
    head = "G21 G90 G17 F100 (an edit)\n"
    main, sub = 4 + 1, 7
    assert sorted(_gone_through(f"{head}{SUBS}{CALLS}M2\n", monkeypatch)) == [main, sub, sub, sub, sub]
    assert _gone_through(f"{head}G0 X5\n{SUBS}{CALLS}M2\n", monkeypatch) == []
    edited = SUBS.replace("G0 X#103", "G0 X[#103*2]")
    assert _gone_through(f"{head}{edited}{CALLS}M2\n", monkeypatch) == [sub]


def test_lines_without_parameters_cost_nothing() -> None:
    flat = "".join(f"G1 X{at} Y2.5\n" for at in range(5_000))
    found = known(analysed(f"{FRAME}{flat}#3=5\n{flat}G0 X#3\nM2\n", "rs274"))
    assert found is not None and found.taking == {5_001, 10_002, 10_003}


def test_a_program_of_computed_moves_is_left_alone() -> None:
    moves = "G1 X[#3*2.5] Y[#3+1]\n" * 21_000
    assert known(analysed(f"{FRAME}#3=5\n{moves}G0 X[1/[#3-5]]\nM2\n", "rs274")) is None


PASSES: dict[str, tuple[str, int, int | None]] = {
    "a loop that counts up": ("#3=0\no1 while [#3 LT 100]\n#3=[#3+10]\no1 endwhile\n", 2, 10),
    "down, by a step that a parameter holds": ("#3=7 #4=2\no1 while [#3 GT 0]\n#3=[#3-#4]\no1 endwhile\n", 2, 4),
    "one that makes no pass": ("#3=5\no1 while [#3 LT 0]\n#3=[#3+1]\no1 endwhile\n", 2, 0),
    "one whose condition stands at its end": ("#3=0\no1 do\n#3=[#3+1]\no1 while [#3 LT 3]\n", 4, 3),
    "one in another one": ("o2 repeat [2]\n#3=0\no1 while [#3 LT 3]\n#3=[#3+1]\no1 endwhile\no2 endrepeat\n", 3, 3),
    "one that may be left": ("#3=0\no1 while [#3 LT 9]\n#3=[#3+1]\no2 if [#5420 GT 1]\no1 break\no2 endif\no1 endwhile\n", 2, None),
    "one that counts on one way only": ("#3=0\no1 while [#3 LT 9]\no2 if [#5420 GT 1]\n#3=[#3+1]\no2 endif\no1 endwhile\n", 2, None),
    "one that counts in a loop of its own": ("#3=0\no1 while [#3 LT 9]\no2 repeat [2]\n#3=[#3+1]\no2 endrepeat\no1 endwhile\n", 2, None),
    "one that counts by what the machine knows": ("#3=0\no1 while [#3 LT 9]\n#3=[#3+#5420]\no1 endwhile\n", 2, None),
    "one that skips the rest of a pass": ("#3=0\no1 while [#3 LT 9]\no2 if [#5420 GT 1]\no1 continue\no2 endif\n#3=[#3+1]\no1 endwhile\n", 2, None),
    "one whose counter a call may set": ("#31=0\no1 while [#31 LT 9]\no<elsewhere> call\n#31=[#31+1]\no1 endwhile\n", 2, None),
}  # fmt: skip
"""A program, the line of a loop's condition from 1, and how often it goes round, if that is certain."""


@pytest.mark.parametrize("name", PASSES)
def test_how_often_a_loop_goes_round(name: str) -> None:
    program, line, times = PASSES[name]
    found = passes_at(analysed(f"{FRAME}{program}M2\n", "rs274"), line)
    assert (None if found is None else found[1]) == times
