"""A program and its expansion make LinuxCNC's interpreter do the same, or both deburr and it refuse the program, on the same line (spec/oracle.md §3)."""

import json
import re
from collections import Counter
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from typing import NamedTuple

import pytest
from benchmarks.interpreter import Program as Asked
from benchmarks.interpreter import answer

from deburr.expand import Inputs, Program, expand
from support.agreement import FACTS
from support.expressions import ARITHMETIC, COMPARED, FUNCTIONS, LOGICAL
from support.flat import MAIN, RULES, STORED, TABLE, Case, difference, ran, verdict
from support.formatting import CANONICAL, laid_out
from support.oracle import SAMPLES
from support.planted import planted
from support.programs import FLOW, MOTION, PREDEFINED, WAYS, Generated, generated
from support.samples import drivers, read, sample

PROGRAMS, CHUNKS = 2_000, 8
LEAST = 0.99
"""The share of the programs that the reference lets run that must be equal."""
USED_AT_LEAST = 20
REFUSED = (0.2, 0.4)
REASONS = 10
CHECKED = 8
"""Of so many random programs that run one is also checked: a check costs more than a run."""
PLANTED, PLANTED_PARTS = 16, 2
"""Of so many random programs one is also run with garbage in branches that never run."""

pytestmark = pytest.mark.oracle
_SKIPPED = "the interpreter does not look at what it passes over; the text is checked all the same (spec/rs274.md §6)"
_UNCLOSED = "runs because the end happens not to be needed; a missing end is always an error (spec/rs274.md §6)"
_LEAKS = (
    "a fault of the interpreter that is not imitated: the documented meaning is run, with a warning (spec/rs274.md §6)"
)
_NUL = "text: NUL"
DIFFERENT: Mapping[str, str] = {
    "faults: while-break, then do": f"the `break` ends the next `do` loop; {_LEAKS}",
    "faults: do { while-break }": f"the `break` ends the `do` loop around; {_LEAKS}",
    "faults: do-continue, then repeat 2": f"the `continue` repeats the next loop; {_LEAKS}",
    "faults: repeat { do-continue }": f"the `continue` makes the `repeat` endless; {_LEAKS}",
    "faults: return out of repeat": f"the `repeat` goes on with the rest of its count; {_LEAKS}",
    "faults: repeat in a recursive sub": f"all calls share one count, without end; {_LEAKS}",
}
"""Programs that run in both and differ."""
STRICTER: Mapping[str, str] = {
    "assign: set inside skipped if": _SKIPPED,
    "flow: garbage in skipped": _SKIPPED,
    "sub: error in uncalled sub": _SKIPPED,
    "faults: call arguments in skipped": _SKIPPED,
    "flow: if without endif true": _UNCLOSED,
    "flow: while w/o endwhile true": _UNCLOSED,
    "flow: do without while": _UNCLOSED,
    "files: M2 before endsub": _UNCLOSED,
    "files: sub in a sub of a file": "later versions refuse it; what this one makes of it is never meant (spec/oracle.md §4)",
    _NUL: "a text with a NUL in it is no program (interface, *Input bytes*)",
}
"""Programs that run there and are refused here, on purpose."""
LOOSER: Mapping[str, str] = {
    "text: empty file": "an empty file is no program yet; its expansion is as empty, and as little accepted (spec/rs274.md §1.1)",
    "text: blank only": "as an empty file (spec/rs274.md §1.1)",
    "text: M100 user": "M100 to M199 are files on the control (spec/rs274.md §5)",
}
"""Programs that are refused there and expanded here."""


@cache
def facts() -> dict[str, Case]:
    found = {}
    for group, name, text, *more in json.loads(FACTS.read_text(encoding="utf-8")):
        found[f"{group}: {name}"] = Case(f"{group}: {name}", text, more[0] if more else {})
    return found


def verdicts(cases: list[Case]) -> dict[str, str]:
    with ThreadPoolExecutor(2) as pool:
        return {case.name: said for case, said in zip(cases, pool.map(verdict, cases)) if said}


class Tally(NamedTuple):
    """How many programs the interpreter runs, how many of them have an equal expansion, how many are refused here on purpose."""

    run: int
    equal: int
    refused: int

    @property
    def let(self) -> int:
        """How many the reference lets run: those that it runs otherwise than the interpreter are among them, as unequal."""
        return self.run - self.refused


def test_all_facts_and_samples(capsys: pytest.CaptureFixture[str]) -> None:
    parts = {"facts": facts_run(), "samples": samples_run()}
    both = Tally(*map(sum, zip(*parts.values())))
    with capsys.disabled():
        for name, part in {**parts, "facts and samples together": both}.items():
            print(f"\n{name}: {said_of(part)}", end="")
        print("".join(f"\n  {name}: {why}" for name, why in (DIFFERENT | STRICTER | LOOSER).items()))
    assert both.equal >= LEAST * both.let


def test_all_facts_and_samples_by_what_is_reached(capsys: pytest.CaptureFixture[str]) -> None:
    """Of all programs that the interpreter runs, where only what is reached may stop deburr's run."""
    cases = [replace(case, reached=True) for case in facts().values()]
    said = verdicts(cases)
    known = {**DIFFERENT, **LOOSER, _NUL: STRICTER[_NUL]}
    assert said.keys() == known.keys(), {name: why for name, why in said.items() if name not in known}
    run = {case.name for case in cases if case.original.status == 0}
    of_facts, of_samples = Tally(len(run), len(run - said.keys()), 1), samples_reached()
    both = Tally(*map(sum, zip(of_facts, of_samples)))
    with capsys.disabled():
        print(f"\nby what is reached: {said_of(both)}", end="")
    assert both.equal >= LEAST * both.run


def samples_reached() -> Tally:
    with ThreadPoolExecutor(2) as pool:
        cases = [replace(case, reached=True) for case in (*map(sample, sorted(SAMPLES.rglob("*.ngc"))), *drivers())]
        runs = list(pool.map(lambda case: case.original, cases))
        clean = [case for case, run in zip(cases, runs) if run.status == 0]
        assert [case.name for case in clean if case.refused] == []
        assert [case.name for case, said in zip(clean, pool.map(difference, clean)) if said] == []
    return Tally(len(clean), len(clean), 0)


_SKIPPED_FROM = {
    "a branch": ("o1 if [0]\n{}\no1 endif\nG0 X1\nM2\n", {}),
    "a loop that is left": ("o1 while [1]\nG0 X2\no1 break\n{}\no1 endwhile\nG0 X1\nM2\n", {}),
    "a sub": ("o1 sub\n{}\no1 endsub\nG0 X1\nM2\n", {}),
    "a file above its sub": ("o<a> call\nG0 X1\nM2\n", {"a.ngc": "{}\no<a> sub\nG0 X5\no<a> endsub\n"}),
    "a file behind a return": ("o<a> call\nG0 X1\nM2\n", {"a.ngc": "o<a> sub\nG0 X5\no<a> return\n{}\no<a> endsub\n"}),
    "nothing": ("G0 X1\n{}\nG0 X3\nM2\n", {}),
}
"""Programs with a line that none of them comes to, but for the last."""
_GARBAGE = (
    "foo $$ [", ")", "G0 X1 X2", "#1=[1/0]", "(a (b) c)", "(open", "G0 " + "X1" * 130, "%", "/foo", "N-5", "N5 N6", "o3 foo",
    "o3 if", "o1.5 if [1]", "o9 endif", "o9 if [1] G0", "o9 sub\no9 endsub", "o9 call 5", "o[1/0] call", "#<foo=3",
    "G0 X#<nope>", "o6 while [1]", "o6 do", "o6 repeat #1", "o1 if [1]", "(ABORT,x)",
)  # fmt: skip


@pytest.mark.parametrize("place", _SKIPPED_FROM)
def test_what_is_passed_over_stops_a_run_as_it_stops_the_interpreter(place: str) -> None:
    text, files = _SKIPPED_FROM[place]
    cases = [
        Case(
            garbage,
            text.replace("{}", garbage),
            {name: one.replace("{}", garbage) for name, one in files.items()},
            reached=True,
        )
        for garbage in _GARBAGE
    ]
    assert verdicts(cases) == {}
    assert len({bool(case.refused) for case in cases}) == 2 or place in ("nothing", "a file behind a return")


def said_of(part: Tally) -> str:
    return (
        f"{part.equal} of {part.run} programs that run are equal ({100 * part.equal / part.run:.1f} %);"
        f" {part.equal} of the {part.let} that the reference lets run ({100 * part.equal / part.let:.1f} %)"
    )


def facts_run() -> Tally:
    cases = list(facts().values())
    assert len(cases) == 458
    said = verdicts(cases)
    known = {**DIFFERENT, **STRICTER, **LOOSER}
    assert said.keys() == known.keys(), {name: why for name, why in said.items() if name not in known}
    assert all(re.search(r"\(spec/|\(interface", why) for why in known.values()), "an exception says what asks for it"
    run = {case.name for case in cases if case.original.status == 0}
    assert run >= STRICTER.keys()
    return Tally(len(run), len(run - said.keys()), len(STRICTER))


ARCS = {
    "G21, half": "G21 G90 F100\nG0 X0 Y0\nG2 X#1 Y0 R[#1/2]\n",
    "G20, half, from a computed point": "G20 G90 F100\nG0 X[1/7] Y[1/3]\nG3 X[1/7+#1] Y[1/3] R[#1/2]\n",
    "steps": "G21 G91 F100\nG0 X[1/7]\nG2 X#1 Y0 R[#1/2]\nX0 Y#1 R[#1/2]\n",
    "almost half": "G21 G90 F100\nG0 X0 Y0\nG2 X#1 Y0 R[#1/2+0.000001]\n",
    "a third": "G19 G90 F100\nG0 Y0 Z0\nG3 Y#1 Z[#1/9] R-[#1*0.7]\n",
    "in a file that is called": "G90 F100\nG0 X[1/7] Y0\no<arc> call [1/7] [#1]\n",
}
"""Arcs in R form of a size #1."""


@pytest.mark.parametrize("name", ARCS)
def test_rounding_moves_no_centre(name: str) -> None:
    files = {"arc.ngc": "o<arc> sub\nG2 X[#1+#2] R[#2/2]\no<arc> endsub\n"}
    for size in ("1/3", "100/3", "1000/7", "12.3456789"):
        case = Case(name, f"#1=[{size}]\n{ARCS[name]}M2\n", files)
        found = expand([Program(case.main, case.document)], RULES, case.host, Inputs(simulate=True))
        flat = ran(
            {TABLE: case.tools, STORED: case.all_files[STORED], MAIN: "".join(f"{line}\n" for line in found.lines)}
        )
        assert (flat.calls, flat.status) == (case.original.calls, 0), (size, found.lines, found.faults)


JUDGED_ALIKE = (
    "G81 X1 Z-1 R-2", "G81 X1 Z1 R0", "G81 X1 Z-1 R-1", "G81 X1 Z-1 R-1.00000001", "G91 G81 X1 Z-1 R0", "G82 X1 Z0 R-1 P1",
    "G83 X1 Z0 R-1 Q1", "G18 G81 X1 Y0 R-1", "G19 G81 Y1 X0 R-1", "#1=2\nG81 X1 Z-1 R[0-#1]", "G43.2", "G43.2 H1", "#1=1\nG43.2",
)  # fmt: skip
"""Cycles whose level R lies below, at or above their depth, and further tool offsets with and without a tool."""


def test_cycles_below_their_level_and_offsets_of_no_tool_are_refused_where_the_interpreter_does() -> None:
    assert verdicts([Case(lines, f"G21 F100 M3 S100 G0 Z5\n{lines}\nM2\n") for lines in JUDGED_ALIKE]) == {}


@pytest.mark.parametrize("part", range(2))
def test_facts_are_refused_on_the_same_line(part: int) -> None:
    cases = [case for case in facts().values() if case.refused and case.name not in STRICTER][part::2]
    with ThreadPoolExecutor(2) as pool:
        asked = [Asked(case.main, case.text, tuple(case.files.items())) for case in cases]
        for case, said in zip(cases, pool.map(answer, asked)):
            assert not said.ran, case.name
            texts = {case.all_files[file].split("\n")[row] for file, row in case.wrong | case.stopped}
            # A line that stands twice in a program is found at its first place.
            same = (said.file, said.line) in case.wrong | case.stopped or said.echo.strip() in {
                each.strip() for each in texts
            }
            assert said.endless or said.line is None or same, (case.name, said, case.refused)


def samples_run() -> Tally:
    programs = [sample(path) for path in sorted(SAMPLES.rglob("*.ngc"))]
    calls = drivers()
    assert len(programs) == 185
    with ThreadPoolExecutor(2) as pool:
        runs = list(pool.map(lambda case: case.original, [*programs, *calls]))
        clean = [case for case, run in zip([*programs, *calls], runs) if run.status == 0]
        wrong = [(case.name, sorted(case.refused)) for case in clean if case.refused]
        differ = [(case.name, said) for case, said in zip(clean, pool.map(difference, clean)) if said]
        otherwise = [case.name for case in pool.map(run_otherwise, clean[:120]) if case is not None]
    whole = sum(run.status == 0 for run in runs[: len(programs)])
    assert whole == 120
    assert len(clean) - whole >= 150
    assert (wrong, differ, otherwise) == ([], [], [])
    return Tally(len(clean), len(clean) - len(differ) - len(wrong), 0)


def run_otherwise(case: Case) -> Case | None:
    """A program of which the interpreter makes something else once it is laid out, in letters as the manual has them."""
    new = replace(case, text=laid_out(case.text, "rs274", CANONICAL))
    assert laid_out(new.text, "rs274", CANONICAL) == new.text
    same = new.text == case.text or (new.original.status, new.original.calls) == (
        case.original.status,
        case.original.calls,
    )
    return None if same else case


def test_libraries_are_laid_out_without_a_change_of_tokens() -> None:
    """What no program of the samples calls is proven by its tokens alone: blanks and the case of letters outside comments are all that differs."""
    changed = 0
    for path in sorted(SAMPLES.rglob("*.ngc")):
        text = read(path)
        new = laid_out(text, "rs274")
        assert laid_out(new, "rs274") == new, path.name
        for old_line, line in zip(text.split("\n"), new.split("\n"), strict=True):
            assert squeezed(old_line) == squeezed(line), path.name
        changed += new != text
    assert changed > 100


def squeezed(line: str) -> list[str]:
    """A line without the blanks outside comments and at its end."""
    parts = re.split(r"(\([^()]*\)|;.*)", line.rstrip())
    return ["".join(part.split()) if at % 2 == 0 else part for at, part in enumerate(parts)]


@cache
def programs(chunk: int) -> tuple[Generated, ...]:
    return tuple(generated(seed) for seed in range(chunk, PROGRAMS, CHUNKS))


def case_of(number: int, program: Generated) -> Case:
    checked = program.misuse == "" and number % CHECKED == 0
    return Case(str(number), program.text, program.files, checked=checked, tagged=True)


@pytest.mark.parametrize("chunk", range(CHUNKS))
def test_random_programs(chunk: int) -> None:
    cases = [case_of(number, program) for number, program in enumerate(programs(chunk))]
    said = verdicts(cases)
    # What is wrong as it stands is refused wherever it stands; the interpreter only refuses what it comes to.
    passed = [name for name in said if cases[int(name)].wrong and not cases[int(name)].stopped]
    assert len(passed) <= len(cases) // 100
    assert {name: why for name, why in said.items() if name not in passed} == {}
    reasons = Counter(fault.kind for case in cases for fault in case.expansion.faults[-1:] if case.stopped)
    share = sum(bool(case.refused) for case in cases) / len(cases)
    assert REFUSED[0] <= share <= REFUSED[1], share
    assert len(reasons) >= REASONS, reasons


@pytest.mark.parametrize("part", range(PLANTED_PARTS))
def test_random_programs_with_garbage_that_never_runs(part: int) -> None:
    programs = [planted(seed) for seed in range(part, PROGRAMS, PLANTED * PLANTED_PARTS)]
    cases = [Case(str(at), each.text, each.files, reached=True) for at, each in enumerate(programs)]
    assert verdicts(cases) == {}
    run = [case for case in cases if not case.refused]
    warned = [case for case in run if any(fault.passed for fault in case.expansion.faults)]
    assert len(run) > len(cases) / 3 and len(warned) > 0.9 * len(run)


def test_random_programs_use_all_of_the_language() -> None:
    used, count = Counter[str](), 0
    for chunk in range(CHUNKS):
        for program in programs(chunk):
            used.update(program.used)
            count += 1
    assert count == PROGRAMS == 2_000
    wanted = (*ARITHMETIC, *COMPARED, *LOGICAL, *FUNCTIONS, *FLOW, *PREDEFINED, *MOTION, *WAYS)
    rare = {name: used[name] for name in wanted if used[name] < USED_AT_LEAST}
    assert rare == {}
