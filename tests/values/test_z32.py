"""Z32: what is proven at each line, and that it holds in runs (spec/z32.md §4 to §6)."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from random import Random

import pytest

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.z32.fields import Fields, Step
from deburr.expand.z32.run import Run
from deburr.expand.z32.state import State
from deburr.expand.z32.unit import Op, Unit
from deburr.finding import Finding, Severity
from deburr.ruleset import RuleSet
from deburr.values import proving, values_of
from deburr.values.domain import Value, joined
from deburr.values.graph import Calls, Env, Graph, Key
from deburr.values.solve import Solution
from deburr.values.words import said
from deburr.values.z32.expressions import ALIAS, named
from deburr.values.z32.fields import fields_of
from deburr_grammar.document import Document
from deburr_grammar.tree import Node
from support.pages import MemoryHost
from support.z32 import DIALECT, MAIN
from support.z32programs import SETTINGS, Generated, generated, given

Place = tuple[str, int, int]
"""A file, a row, and which field of the line."""
RUNS = 2


def analysed(program: Generated, delete: bool | None = None) -> Analysis:
    """A program as it is checked."""
    ruleset = _ruleset(str(program.settings["cmos-dir"]))
    inputs = Inputs(block_delete=delete)
    return Analysis(Document.parse(program.text, DIALECT), ruleset, MAIN, MemoryHost(program.files), inputs=inputs)


@cache
def _ruleset(folder: str) -> RuleSet:
    return RuleSet(DIALECT, {**SETTINGS, "cmos-dir": folder})


def proofs(analysis: Analysis) -> list[Finding]:
    """What is proven to go wrong."""
    return [each for each in proving(analysis) if each is not None]


class Known:
    """What is proven of a program: the values before each field, the fields that cannot be passed, and the loops that never end."""

    def __init__(self, analysis: Analysis) -> None:
        program = values_of(analysis)
        assert program is not None
        self.before: dict[Place, dict[Key, Value]] = {}
        stopping: dict[Place, bool] = {}
        self.endless: set[Place] = set()
        for name, solved in program.solved.items():
            routine = program.routines[name]

            def place(number: int, files=routine.files, rows=routine.rows, nodes=routine.graph.nodes) -> Place:  # type: ignore[no-untyped-def]
                node = nodes[number]
                return files[node.line] if files is not None else MAIN, rows[node.line], node.part

            for number, env in solved.solution.before.items():
                at, old = place(number), self.before.get(place(number))
                self.before[at] = (
                    env if old is None else {key: joined(old[key], env[key]) for key in old.keys() & env.keys()}
                )
                stopping[at] = stopping.get(at, True) and number in solved.solution.proofs
        self.stopping = {at for at, stops in stopping.items() if stops}
        self.taking = {
            (file or MAIN, row)
            for routine in program.routines.values()
            for file, row in zip(routine.files or [""] * len(routine.rows), routine.rows)
        }


class Watch:
    """Looks at the parameters before each field and block that is executed."""

    def __init__(self, known: Known, findings: list[Finding]) -> None:
        self._known = known
        self._findings = {(each.place.file, each.place.line, each.place.col): each for each in findings}
        self.wrong: list[tuple[object, ...]] = []
        self.seen = 0
        self.passed: set[tuple[str, int]] = set()
        self.jumped: set[tuple[str, int]] = set()
        """The lines of jumps with a return that were made."""

    def line(self, text: str) -> None:
        """Nobody wants the lines."""

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Have each of them looked at."""
        compiled, step = Run._compiled, Fields.step

        def compiling(run: Run, unit: Unit, row: int) -> Op:
            op, kinds = compiled(run, unit, row), unit.document.node(row).kinds
            self.passed.add((unit.file, row))
            if (unit.file, row) not in self._known.taking or "advanced" in kinds:
                return op
            executed: Op = self._around((unit.file, row, 0), run._state, op)
            if unit.code[row] is not None:
                unit.code[row] = executed
            return executed

        def stepping(fields: Fields, field) -> Step:  # type: ignore[no-untyped-def]
            node = fields._state.program.unit.document.node(fields._row)
            parts = [each.start for group in fields_of(node) for each in group]
            place = (fields._values._file, fields._row, parts.index(field.start))
            op = self._judged(place, field, step(fields, field))
            return self._around(place, fields._state, op) if place[:2] in self._known.taking else op

        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Run, "_compiled", compiling)
            patch.setattr(Fields, "step", stepping)
            yield

    def _judged(self, place: Place, field: Node, op: Step) -> Step:
        """A field that may be a condition which decides nothing, or a jump with a return."""
        found = self._findings.get((*place[:2], field.children[1].start)) if field.kind == "if" else None

        def executed() -> int | None:
            behind = op()
            if found is not None and (behind is None) != ("always" in found.message):
                self.wrong.append((place, found.message))
            if field.kind == "jump" and field.node("range_end") is not None:
                self.jumped.add(place[:2])
            return behind

        return executed

    def open(self, job: Job) -> list[object]:
        """The jumps that are proven never to return, but of which a run that has come to its end says nothing."""
        met = {(fault.kind, fault.file, fault.line) for fault in job.faults}
        proven = [each.place[:2] for each in self._findings.values() if each.rule == "z32.range-open-at-end"]
        return [place for place in proven if place in self.jumped and ("range-open-at-end", *place) not in met]

    def _around(self, place: Place, state: State, op: Callable[[], int | None]) -> Callable[[], int | None]:
        def executed() -> int | None:
            self._look(place, state)
            behind = op()
            if place in self._known.stopping:
                self.wrong.append((place, "is passed"))
            return behind

        return executed

    def _look(self, place: Place, state: State) -> None:
        env = self._known.before.get(place)
        if env is None:
            self.wrong.append((place, "is reached"))
        for key, value in (env or {}).items():
            if isinstance(key, str):
                self.seen += 1
                got = _held(state, key)
                if got is None or not value.has(got):
                    self.wrong.append((place, key, value, got))


def _held(state: State, key: str) -> float | None:
    if key == ALIAS:
        return named(state.alias).low if state.alias else None
    if "[" in key:
        return (state.pal if key[2] == "L" else state.par)[int(key[4:-1])]
    return state.params.get(key)


def watched(seed: int) -> int:
    """Run the program of a seed with some inputs beside its values; how many values were looked at."""
    program, rng = generated(seed), Random(seed)
    delete = rng.choice((None, False, True))
    analysis = analysed(program, delete)
    if values_of(analysis) is None:
        return 0
    known = Known(analysis)
    findings = proofs(analysis)
    watch = Watch(known, findings)
    endless = {finding.place.line for finding in findings if finding.rule == "z32.limit"}
    with watch.watching():
        for _ in range(RUNS):
            watch.passed.clear()
            watch.jumped.clear()
            inputs = Inputs(given(rng), block_delete=rng.choice((False, True)) if delete is None else delete)
            job = Job(
                (Program(MAIN, analysis.document),), analysis.ruleset, analysis.host, watch, inputs, Budget(400, 0)
            )
            for _ in drive(job):
                pass
            assert watch.wrong == [], f"seed {seed} with {inputs.define}, {inputs.block_delete}: {watch.wrong[:3]}"
            looping = [row for row in endless if (MAIN, row) in watch.passed]
            if not job.cut and all(fault.kind == "range-open-at-end" for fault in job.faults):
                assert looping == [], f"seed {seed}: the loop of line {looping} ended"
                assert watch.open(job) == [], f"seed {seed}: {watch.open(job)} came back"
    return watch.seen


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


@pytest.fixture(scope="module")
def _tables_at_rest() -> Iterator[None]:
    """What was made before, such as the tables of the parser, need not be looked through for garbage again and again."""
    gc.freeze()
    yield
    gc.unfreeze()


@pytest.mark.usefixtures("_tables_at_rest")
@pytest.mark.parametrize("first", range(0, 1_000, 100))
def test_runs_see_what_is_proven(first: int) -> None:
    """Each value that the interpreter sees lies in the range of its place, and nothing is passed of which a fault is proven."""
    assert sum(watched(seed) for seed in range(first, first + 100)) > 1_000


def test_a_wrong_range_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The proof that runs are looked at: with a false IF that goes on as if it were true, many differ."""
    from deburr.values.z32 import conditions

    monkeypatch.setitem(conditions._OPPOSITE, "<", "<")
    with pytest.raises(AssertionError, match="seed"):
        for seed in range(90_000, 90_200):
            watched(seed)


SECTIONS = "".join(
    f":{at}\nH{name}<HA>\nN10 X<H{name}>\n!H{name}=H{name}+1; IF H{name}<9; GON10!\nG26\n"
    for at, name in enumerate("BCDE", 1)
)
CALLS = "".join(f"!GOP{at}!\n" for at in range(1, 5))


def _gone_through(text: str, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many nodes each part has that is gone through."""
    made: list[int] = []

    class Counted(Solution):
        def __init__(self, graph: Graph, entry: Env, calls: Calls, forgotten: frozenset[Key] = frozenset()) -> None:
            made.append(len(graph.nodes))
            super().__init__(graph, entry, calls, forgotten)

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
