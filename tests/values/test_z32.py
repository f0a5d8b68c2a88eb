"""Z32: what is proven at each line, and that it holds in runs (spec/z32.md §4 to §6)."""

from __future__ import annotations

from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding, Severity
from deburr.ruleset import RuleSet
from deburr.values import proving, values_of
from deburr.values.graph import Graph, Key
from deburr.values.solve import Solution
from deburr.values.words import said
from deburr_grammar.document import Document
from support.pages import MemoryHost
from support.z32 import DIALECT, MAIN


def proofs(analysis: Analysis) -> list[Finding]:
    """What is proven to go wrong."""
    return [each for each in proving(analysis) if each is not None]


MEANT: dict[str, tuple[str, int, Key, str]] = {
    "a constant": ("HA<2*5>\nX<HA>\n", 2, "HA", "10"),
    "what the machine knows": ("HA<PAL[300]>\nX<HA>\n", 2, "HA", ""),
    "what is configured of the machine": ("HA<PAL[301]+1>\nX<HA>\n", 2, "HA", "8"),
    "a loop that counts up": ("HA0\nN10 X<HA>\n!HA=HA+10; IF HA<100; GON10!\n", 2, "HA", "0 … 90 step 10"),
    "behind a loop that counts up": ("HA0\nN10 X<HA>\n!HA=HA+10; IF HA<100; GON10!\nY<HA>\n", 4, "HA", "100"),
    "a loop in a loop": ("HA0\nN10 HB8\nN20 X<HB>\n!HB=HB-2; IF HB>0; GON20!\n!HA=HA+1; IF HA<3; GON10!\n", 3, "HB", "2 … 8 step 2"),
    "the outer one in the inner one": ("HA0\nN10 HB8\nN20 X<HB>\n!HB=HB-2; IF HB>0; GON20!\n!HA=HA+1; IF HA<3; GON10!\n", 3, "HA", "0 … 2, integers"),
    "a loop that is entered in its middle": ("HA5\n!GON20!\nN10 HA<HA+1>\nN20 X<HA>\n!IF HA<9; GON10!\n", 4, "HA", "5 … 9, integers"),
    "one way of two": ("HA1\n!IF PAL[300]>0; HA=4!\nX<HA>\n", 3, "HA", "1 … 4 step 3"),
    "behind EB": ("HA1\n!IF PAL[300]>0; HA=4; EB! HA=7!\nX<HA>\n", 3, "HA", "4 … 7 step 3"),
    "without EB": ("HA1\n!IF PAL[300]>0; HA=4! HA=7!\nX<HA>\n", 3, "HA", "7"),
    "a condition of two": ("HA<INT(PAR[1])>\n!IF HA>2; IF HA<=9; GON20!\nM30\nN20 X<HA>\n", 4, "HA", "3 … 9, integers"),
    "nine digits are the same": ("HA<PAR[1]>\n!IF HA<5; GON20!\nX<HA>\nN20\n", 3, "HA", "at least 4.999999995"),
    "PAL is rounded": ("PAL[1]2.5\nX<PAL[1]>\n", 2, "PAL[1]", "3"),
    "PAR is not": ("PAR[1]2.5\nX<PAR[1]>\n", 2, "PAR[1]", "2.5"),
    "one of several by a computed index": ("PAR[1]5\nPAR[2]9\n!HA=1; IF PAL[300]>0; HA=2!\nPAR[HA]3\nX<PAR[1]>\n", 5, "PAR[1]", "3 … 5 step 2"),
    "the index of which is rounded": ("PAR[3]5\nHA<3.0000001>\nX<PAR[HA]>\nHB<PAR[HA]>\nX1\nX<HB>\n", 6, "HB", "5"),
    "an axis by its alias": ("G25YZX\nAA7\nHA<Y>\nX<HA>\n", 4, "HA", "7"),
    "an axis that a word sets": ("X5\nX6\nHA<X>\nY<HA>\n", 4, "HA", "6"),
    "what a program sets that is called": ("HA1\n!GOP1!\nX<HB>\nM30\n:1\n!HB=HA+1!\nG26\n", 3, "HB", "2"),
    "what it leaves alone": ("HA1\n!GOP1!\nX<HB>\nM30\n:1\n!HB=HA+1!\nG26\n", 3, "HA", "1"),
    "what all calls give": ("HA1\n!GOP1!\nHA5\n!GOP1!\nM30\n:1\nX<HA>\nG26\n", 7, "HA", "1 … 5 step 4"),
    "what calls give behind a loop": ("HA3\nN10 X<HA>\n!HA=HA-1; IF HA>0; GON10!\n!GOP1!\nM30\n:1\nY<HA>\nG26\n", 7, "HA", "0"),
    "what a file sets": ("HA1\n!:L254-A1!\nX<HB>\n", 3, "HB", "4"),
    "what nobody can see sets": ("HA1\n!GOP7!\nX<HA>\n", 3, "HA", ""),
    "behind a range": ("HA1\n!GON20-N30!\nX<HA>\nM30\nN20 HA<HA+4>\nN30\n", 3, "HA", "5"),
    "in a range of two jumps": ("HA1\n!GON20-N30!\nHA7\n!GON20-N30!\nM30\nN20 X<HA>\nN30\n", 6, "HA", "1 … 7 step 6"),
    "a range that is left and closed later": ("HA1\n!GON20-N30!\nX<HA>\nM30\nN20 HA2\n!GON40!\nN30\nM30\nN40 HA3\n!GON30!\n", 3, "HA", "3"),
    "a polar radius": ("HX<PAL[300]>\nHY3\n!CP!\nX<HR>\n", 4, "HR", "at least 3"),
    "a line that the operator may leave out": ("HA1\n/HA2\nX<HA>\n", 3, "HA", "1 … 2, integers"),
}  # fmt: skip
"""A program behind its first line, a line of it from 1, a parameter, and what it holds before that line."""


def _analysed(program: str) -> Analysis:
    files = {"files/A1.z32": "!HB=HA+3!\nG26\n"}
    ruleset = RuleSet(DIALECT, {"file-root": "files", "pal": {"301": 7}})
    return Analysis(Document.parse(f"(P)\n{program}M30\n", DIALECT), ruleset, MAIN, MemoryHost(files))


@pytest.mark.parametrize("name", MEANT)
def test_what_a_parameter_holds(name: str) -> None:
    program, line, key, text = MEANT[name]
    found = values_of(_analysed(program))
    assert found is not None
    value = found.value(MAIN, line, key, False)
    assert ("" if value is None else said(value)) == text, value


SILENT = {
    "a value that only the machine knows": "HA<PAL[300]>\nX<5/HA>\n",
    "a parameter that an earlier program may have set": "X<5/HA>\nPAR[1]<PAR[2]/PAR[3]>\n",
    "one way of two": "HA0\n!IF PAL[300]>0; HA=1!\nX<5/HA>\n",
    "a loop that the machine ends": "N10 HA<PAL[300]>\n!IF HA<5; GON10!\n",
    "a loop that is left": "HA0\nN10 X<HA>\n!HA=HA+1; IF HA>5; GON20!\n!IF HA>0; GON10!\nN20\n",
    "a loop in which the program ends": "HA0\nN10 X<HA>\n!HA=HA+1; IF HA>5; GOP1!\n!IF HA>0; GON10!\nM30\n:1\nM30\n",
    "a program that repeats": "HA1\nN10 X<HA>\n!HB=HB+1!\n!IF HA=1; GON10!\n",
    "a loop that runs out of cells": "HA200\nN10 PAL[HA]1\n!HA=HA+1; IF HA>0; GON10!\n",
    "a line that the operator may leave out": "HA5\n/HA0\nX<5/HA>\n",
    "a section that one of two calls breaks": "HA0\n!IF PAL[300]>0; GOP1!\nHA1\n!GOP1!\nM30\n:1\nX<5/HA>\nG26\n",
    "a section into which the main program also runs": "HA0\n!IF PAL[300]>0; GOP1!\nHA1\n!GON10!\n:1\nN10 X<5/HA>\nG26\n",
    "a switch": "HA0\nX1\n!IF HA=1; GON20!\nY1\nN20 X2\n",
    "a guard": "HA<ABS(PAL[300])>\n!IF HA<0; GON90!\nX<HA>\nM30\nN90 G0 Z100\nM30\n",
    "an index that may be right": "HA0\nN10 PAL[HA]1\n!HA=HA+1; IF HA<=256; GON10!\n",
    "a range that comes back now and then": "!GON20-N30!\nM30\nN20 !IF PAL[300]>0; GON40!\nN30\nN40 G0 Z5\n",
    "a line that cannot be read": "HA0\n!HA=(1!\nX<5/HA>\n",
    "a jump that nobody can follow": "HA0\n!IF PAL[300]>0; GON<HB>!\nHA1\nN10 X<5/HA>\nN20 HC1\n",
    "a file that nobody has": "HA0\n!:L254-GONE!\nX<5/HA>\n",
}  # fmt: skip


@pytest.mark.parametrize("name", SILENT)
def test_nothing_is_said_of_what_is_not_proven(name: str) -> None:
    assert [each for each in proofs(_analysed(SILENT[name])) if each.severity > Severity.INFO] == []


ALIKE: dict[str, list[tuple[str, int, int, int]]] = {
    "X<5/(HA-2)>\nX<500/(HA-10)>\nX<50/(HA-1)>\n": [("z32.divide-by-zero", 5, 5, 11)],
    "PAL[10]<HA+1>\nPAL[9]<HA+20>\n!PAR[1]=10/(PAL[9]-2)!\n!PAR[5]=100/(PAL[10]-2)!\n": [("z32.divide-by-zero", 6, 12, 23)],
    "!IF HA>100; HB=1!\n!IF HA>0; HB=1!\n!IF HA>10; HB=1!\nX<HB>\n": [
        ("z32.condition-constant", 3, 4, 10),
        ("z32.condition-constant", 4, 4, 8),
        ("z32.condition-constant", 5, 4, 9),
    ],
    "!HB=1/2!\n!HB=1/0!\n": [("z32.divide-by-zero", 4, 6, 7)],
}  # fmt: skip
"""Behind `HA1` and a line that calculates it again: lines that differ only in their numbers, and where something is found."""


@pytest.mark.parametrize("text", ALIKE)
def test_lines_that_differ_in_their_numbers_are_told_apart(text: str) -> None:
    found = [(each.rule, each.place) for each in proofs(_analysed(f"HA1\nHA<HA*1>\n{text}"))]
    assert [(rule, at.line, at.col, at.end_col) for rule, at in found] == ALIKE[text]


def test_the_chain_is_told() -> None:
    program = "HA3\nN10 X<HA>\n!HA=HA-1; IF HA>0; GON10!\n!GOP1!\nX<1/HB>\nM30\n:1\n!HB=HA*2!\nG26\n"
    (found,) = proofs(_analysed(program))
    assert [(each.place.line, each.message) for each in found.related] == [
        (4, "`HB` is set by what is called here, it holds 0")
    ]
    (found,) = proofs(_analysed(program.replace("HB=HA*2", "HB=2/HA")))
    assert (found.rule, found.place.line) == ("z32.divide-by-zero", 8)
    assert [(each.place.line, each.message) for each in found.related] == [
        (4, "called here"),
        (3, "from here on `HA`, it holds 0"),
        (3, "`HA` is set here, it holds 0 … 2, integers"),
    ]


def test_a_fault_in_a_called_file_is_found_from_the_program_that_calls_it() -> None:
    (found,) = proofs(_analysed("HA<-3>\n!:L254-A1!\nX<1/HB>\n"))
    assert (found.place.file, found.place.line) == (MAIN, 3)
    ruleset = RuleSet(DIALECT, {"file-root": "files"})
    host = MemoryHost({"files/A1.z32": "HB<1/HA>\nG26\n"})
    (found,) = proofs(Analysis(Document.parse("HA0\n!:L254-A1!\nM30\n", DIALECT), ruleset, MAIN, host))
    assert (found.place.file, found.place.line, found.place.col) == ("files/A1.z32", 0, 5)
    assert [(each.place.file, each.place.line) for each in found.related] == [(MAIN, 1), (MAIN, 0)]


SECTIONS = "".join(
    f":{at}\nH{name}<HA>\nN10 X<H{name}>\n!H{name}=H{name}+1; IF H{name}<9; GON10!\nG26\n"
    for at, name in enumerate("BCDE", 1)
)
CALLS = "".join(f"!GOP{at}!\n" for at in range(1, 5))


def _gone_through(text: str, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many nodes each part has that is gone through."""
    made: list[int] = []

    class Counted(Solution):
        def __init__(self, graph: Graph, *more: Any) -> None:
            made.append(len(graph.nodes))
            super().__init__(graph, *more)

    with monkeypatch.context() as patch:
        patch.setattr("deburr.values.ledger.Solution", Counted)
        assert values_of(_analysed_whole(text)) is not None
    return made


def _analysed_whole(text: str) -> Analysis:
    return Analysis(Document.parse(text, DIALECT), RuleSet(DIALECT), MAIN, MemoryHost({}))


def test_an_edit_costs_the_section_that_it_touches(monkeypatch: pytest.MonkeyPatch) -> None:
    head = "(AN EDIT)\nHA3\n"
    main, section = 1 + 4 + 1, 1 + 2 + 3 + 1
    assert sorted(_gone_through(f"{head}{CALLS}M30\n{SECTIONS}", monkeypatch)) == [
        main,
        section,
        section,
        section,
        section,
    ]
    assert _gone_through(f"{head}X5 Y<HA>\n{CALLS}M30\n{SECTIONS}", monkeypatch) == [main + 1]
    edited = SECTIONS.replace("X<HD>", "X<HD*2>")
    assert _gone_through(f"{head}{CALLS}M30\n{edited}", monkeypatch) == [section]


def test_lines_without_parameters_cost_nothing() -> None:
    flat = "".join(f"G1 X{at} Y2.5\n" for at in range(5_000))
    found = values_of(_analysed_whole(f"{flat}HA5\n{flat}X<HA>\nM30\n"))
    assert found is not None and [*found.routines["main program"].rows] == [5_000, 10_001, 10_002]
    assert values_of(_analysed_whole(f"{flat}M30\n")) is None


def test_a_program_of_computed_moves_is_left_alone() -> None:
    moves = "G1 X<HA*2.5> Y<HA+1>\n" * 21_000
    assert values_of(_analysed_whole(f"HA5\n{moves}X<1/(HA-5)>\nM30\n")) is None


def test_a_way_back_to_a_line_that_cannot_be_read_is_no_loop() -> None:
    analysis = _analysed_whole("4!GON0-N200\nN200")
    assert proofs(analysis) == []
