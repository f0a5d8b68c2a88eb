"""Z32: the trigger of every rule that a run decides, what a run says in `check`, and runs that must be stopped."""

import tracemalloc

import pytest

from deburr.catalogue import rules_of
from deburr.expand import Budget, Inputs, Job, Program, drive
from deburr.expand.z32.state import DEEPEST, WAITING
from deburr_grammar.document import Document
from support.pages import MemoryHost
from support.z32 import DIALECT, MAIN, RULES, checked, expanded, flat, met

# Braces mark the place that is to be named.
CERTAIN = [
    ("divide-by-zero", "X0\nHA<X*2>\nHB<1/{HA}>"),
    ("divide-by-zero", "X5\n!HA=10/{(X-5)}!"),
    ("domain", "X-4\nHA<{RQ(X)}>"),
    ("domain", "X30\n!HA={TAN(3*X)}*2!"),
    ("domain", "HA9\nN10 HA<{HA*HA}>\n!IF HA>0; GON10!"),
    ("index-range", "HA 513\nPAL[{HA}]1"),
    ("index-range", "HA 1\nX<PAR[{-HA}]>"),
    ("index-not-integer", "HA 3\nX<PAR[{HA/2}]>"),
    ("pal-read-only", "HA 256\n!{PAL[HA]}=1!"),
    ("pal-read-only", "HA 255\n{PAL[HA+1]}<7>"),
    ("pal-rounded", "HA 5\nPAL[1]{<HA/2>}"),
    ("pal-rounded", "HA 5\n!PAL[1]={HA/2}!"),
    ("number-digits", "HA 99999999\nX{<HA*100>}"),
    ("program-number", "HA 3\n!GOP{<HA/2>}!"),
    ("program-missing", "HA 3\n!GOP{<HA>}!\n:1\nG26"),
    ("jump-target-missing", "HA 3\n!GON{<HA*10>}!\nN10 X1"),
    ("jump-target-duplicate", "HA 3\n!GON{<HA*10>}!\nN30 X1\nN30 X2"),
    ("range-end-missing", "HA 3\n!GON10-{N<HA>}!\nN10 X1"),
    ("range-open-at-end", "HA 3\n!GON10-{N30}!\nM30\nN10 X1\n!IF HA=3; GON40!\nN30\nN40 M30"),
    ("call-depth", "HA 1\n!GOP1!\nM30\n:1\n!IF HA>0; GOP{1}!\nG26"),
    ("g26-missing", "HA 1\n!GOP<HA>!\nM30\n:1\n{X1}\n:2"),
    ("polar-origin", "X0\n!HX=X; HY=X; {CP}!"),
    ("alias-unset", "!GON20!\nN10 {AA}1\nM30\nN20 !GON10!\nM30"),
    ("limit", "HA 0\nN10 X1\n!IF HA<1; GON10-{N20}!\nN20\nM30"),
]
"""What a run decides that is given nothing."""

OPEN = [
    ("read-before-set", "X<{HA}>"),
    ("read-before-set", "!HA={PAR[1]}!"),
    ("read-before-set", "HA<{Y}>"),
    ("read-before-set", "X1\n/X2\nY<{X}>"),
    ("read-before-set", "!HX=1; {CP}!"),
    ("read-before-set", "!{PC}!"),
    ("read-before-set", "G25XYZ\nHA<{AB}>"),
    ("pal-machine-value", "X<{PAL[300]}>"),
    ("pal-machine-value", "HA 512\n!IF {PAL[HA]}=1; EB! X=1!"),
    ("optional-state", "{/!HA=1!}"),
    ("optional-state", "X1\n {/N5 PAL[1]1 X2} ;again"[:-7]),
    ("optional-state", "{/G25XYZ}"),
    ("program-missing", "!GOP{7}!"),
    ("file-missing", "!:L254-{A\\B}!"),
    ("g26-outside", "X1\n{G26}"),
    ("alias-unset", "{AA}1"),
    ("divide-by-zero", "HA0\n/X<1/{HA}>\nY1"),
    ("divide-by-zero", "HA0\n/M30\nX<1/{HA}>"),
    ("pal-rounded", "HA0\n/M<HA+30>\nPAL[1]{<HA+0.5>}"),
]
"""What is for `expand` alone: an input that was not given, or a caller, may decide otherwise."""


def marked(rule: str, program: str) -> tuple[str, str]:
    """A program without its braces, and the finding that they ask for."""
    before, _, rest = program.partition("{")
    start = len(before) - before.rfind("\n") - 1
    said = rest.partition("}")[0]
    return before + rest.replace("}", "", 1), f"{rule} {before.count(chr(10)) + 1} {start}-{start + len(said)}"


@pytest.mark.parametrize(("rule", "program"), CERTAIN)
def test_each_trigger_that_a_run_decides_gives_its_rule_and_no_other(rule: str, program: str) -> None:
    program, wanted = marked(rule, program)
    assert met(program) == [wanted]
    if rule != "jump-target-duplicate":
        assert [each for each in checked(program) if not each.startswith("jump-expression")] == [wanted]


@pytest.mark.parametrize(("rule", "program"), OPEN)
def test_what_an_input_decides_ends_a_run_of_check_in_silence(rule: str, program: str) -> None:
    program, wanted = marked(rule, program)
    assert met(program) == [wanted]
    assert checked(program) == []


def test_every_kind_of_fault_is_a_rule() -> None:
    known = {rule.short for rule in rules_of("z32")}
    assert {rule for rule, _ in (*CERTAIN, *OPEN)} <= known


def test_given_values_decide() -> None:
    program = "!IF PAL[300]=1; EB! GON90!\nX<HA>\nM30\nN90 X<1/(HA-HA)>\nM30\n"
    assert checked(program) == []
    assert checked(program, inputs=Inputs({"PAL[300]": "1", "HA": "4"})) == []
    assert checked(program, inputs=Inputs({"HA": "4"}), pal={"300": 2}) == ["divide-by-zero 4 8-15"]
    assert flat(program, define={"PAL[300]": "1", "HA": "4"}) == ["X4", "M30"]


def test_files_that_are_called_are_named() -> None:
    files = {"cmos/1.z32": "HA<1/HB>\nG26\n", "root/A.z32": "!GOP1!\nG26\n"}
    found = expanded("!HB=0!\n!:L254-A!\n", files, settings={"cmos-dir": "cmos", "file-root": "root"})
    (fault,) = found.faults
    assert (fault.kind, fault.file, fault.line, fault.span) == ("divide-by-zero", "cmos/1.z32", 0, (5, 7))
    assert fault.stack is not None
    assert [(each.file, each.row, each.kind.value) for each in fault.stack.outward()] == [
        ("root/A.z32", 0, "call"),
        (MAIN, 1, "file"),
    ]
    assert checked("!HB=0!\n!:L254-A!\n", files, cmos_dir="cmos", file_root="root") == [
        "divide-by-zero cmos/1.z32:1 5-7"
    ]


def test_literal_faults_of_a_called_file_are_met_too() -> None:
    for rule, line in [
        ("divide-by-zero", "HA<1/{0}>"),
        ("index-range", "PAL[{513}]1"),
        ("pal-read-only", "{PAL[256]}1"),
        ("pal-rounded", "PAL[1]{2.5}"),
        ("jump-target-missing", "!GON{99}!"),
        ("file-outside", "!:L254-{..\\X}!"),
        ("program-number", "!GOP{1.5}!"),
        ("g-expression", "G{<HA>}"),
        ("word-syntax", "{=}X"),
    ]:
        text, wanted = marked(rule, line)
        head, row = wanted.split(" ", 1)
        files = {"cmos/1.z32": f"{text}\nG26\n"}
        assert met("!GOP1!", files, cmos_dir="cmos") == [f"{head} cmos/1.z32:{row}"]


def test_a_subprogram_that_is_checked_alone_is_not_called_wrong() -> None:
    for text in (
        "AA1\nX<HA>\nG26\n",
        "G0 X<HB>\nG26\n",
        ":3\nG0 X1\nG26\n:4\nX2\nG26\n",
        "!HA=1!\nG26\n",
        "!IF PAR[1]>0; GON10!\nM30\nN10 X1\nG26\n",
    ):
        assert checked(text) == []


def test_the_first_phase_is_told_whole_and_the_second_to_its_first_error() -> None:
    assert met("HA0\nX.\nX<1/HA>\n!FOO!\n") == ["number-format 2 1-2", "field-unknown 4 1-4"]
    assert met("HA0 PAL[1]<HA+0.5>\nX<1/HA>\nX<2/HA>\n") == ["pal-rounded 1 10-18", "divide-by-zero 2 4-6"]


ENDLESS = [
    ("HA0\nN10 HA<HA+1>\nX<HA>\n!IF HA>=0; GON10!", "with `HA` = 16666"),
    ("N10 X1\n!GON10!", "pass 25,000 of the loop from line 2 to `!GON10!` of line 3"),
    ("HA0\nN10 HB0\nN20 !HB=HB+1; IF HB<30000; GON20!\n!IF HA=0; GON10!", "of the loop from line 4"),
    ("PAL[1]5\nN10\n!IF PAL[300]=0; GON10!", "with `PAL[300]` = 0"),
    ("HA0\nN10 !HA=HA+1!\n!GON<10>!", ""),
]


@pytest.mark.parametrize(("program", "words"), ENDLESS)
def test_a_run_without_end_is_left_at_a_named_place(program: str, words: str) -> None:
    program = f"(P)\n{program}\n"
    found = expanded(program, budget=Budget(50_000, 0), settings={"pal": {"300": 0}})
    (fault,) = found.faults
    assert found.cut and fault.kind == "limit" and words in fault.message and 0 < fault.line < 6
    said = checked(program, pal={"300": 0})
    assert said == [each for each in said if each.startswith("jump-expression")]


GOES_ROUND = [
    ("N10 !GON10!", 2, "the loop to `N10 !GON10!` never ends:"),
    ("N1\n!GON1!", 3, "the loop from line 2 to `!GON1!` never ends:"),
    ("PAL[1]5\nN10 PAL[2]1\n!IF PAL[1]>PAL[2]; GON10!", 4, "never ends with `PAL[1]` = 5 and `PAL[2]` = 1:"),
    ("HA0\nN10\n!GON30!\nN20 !GON10!\nN30 !GON20!", 5, "the loop from line 3 to `N20 !GON10!` never ends:"),
    ("HA0\nN10 HB0\nN20 !HB=HB+1; IF HB<1000; GON20!\n!IF HA=0; GON10!", 5, "the loop from line 3 to `!IF HA=0"),
    ("HA0\nN10 !HA=1-HA!\n!GOP1!\n!GON10!\nM30\n:1\n!HB=HA!\nG26", 5, "the loop from line 3 to `!GON10!`"),
    ("!GOP1!\nM30\n:1\nN10 !HA=1!\n!GON10!\nG26", 6, "the loop from line 5 to `!GON10!`"),
    ("N10\n!GON20-N30!\n!GON10!\nN20 !HA=1!\nN30", 4, "the loop from line 2 to `!GON10!`"),
]


@pytest.mark.parametrize(("program", "line", "words"), GOES_ROUND)
@pytest.mark.parametrize("steps", [50_000, 50_001, 50_003])
def test_what_comes_back_to_the_same_state_without_an_output_is_certain_to_be_endless(
    program: str, line: int, words: str, steps: int
) -> None:
    program = f"(P)\n{program}\n"
    found = expanded(program, budget=Budget(steps, 0))
    (fault,) = found.faults
    assert (found.cut, fault.kind, fault.line + 1) == (False, "limit", line) and words in fault.message
    assert [each.split()[:2] for each in checked(program)] == [["limit", f"{line}"]]


@pytest.mark.parametrize(
    ("program", "kind"),
    [
        ("HA1\n!GOP1!\nM30\n:1\n!GOP1!\nG26", "call-depth"),
        ("HA1\nN10 X1\n!GON10-N20!\nN20", "limit"),
        ("HA1\nN10 X1\n!GON20-N90!\nN20 X2\n!GON10-N80!\nN80\nN90", "limit"),
        ("HA1\nN10 !GON20-N90!\nN20\nN30 !GON40-N30!\nN40 !GON10!\nN90", "limit"),
    ],
)
def test_what_piles_up_has_a_limit(program: str, kind: str) -> None:
    tracemalloc.start()
    (fault,) = (each for each in expanded(program, budget=Budget(0, 0)).faults if each.kind != "range-end-active")
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert fault.kind == kind and peak < 30e6
    assert (f"{DEEPEST} calls" if kind == "call-depth" else f"{WAITING:,} jumps") in fault.message


def test_every_executed_line_is_one_step() -> None:
    program = "(P)\nHA0\n\nN10 X<HA>\n!HA=HA+1; IF HA<100; GON10!\nM30\nX1\n"
    assert len(expanded(program, budget=Budget(204, 0)).lines) == 102
    assert expanded(program, budget=Budget(203, 0)).cut


class Counting:
    """Lines that are only counted."""

    def __init__(self) -> None:
        self.count = 0

    def line(self, text: str) -> None:
        self.count += 1


def test_a_loop_body_is_read_once_and_its_lines_are_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = list[int]()
    node = Document.node
    monkeypatch.setattr(Document, "node", lambda self, line: asked.append(line) or node(self, line))
    document = Document.parse("HA0\nN10 G1 X<HA*2> F100\nY1\n!HA=HA+1; IF HA<30000; GON10!\nM30\n", DIALECT)
    sink = Counting()
    job = Job([Program(MAIN, document)], RULES, MemoryHost({}), sink, Inputs(), Budget(0, 0))
    slices = 0
    tracemalloc.start()
    for _ in drive(job):
        slices += 1
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert not job.faults and sink.count == 60_001 and slices >= 45
    assert len(asked) < 60 and peak < 5e6
