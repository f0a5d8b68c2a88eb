"""CGT: runs that cannot end, runs of faulty templates, runs in slices. Each ends, and says where."""

import tracemalloc

import pytest
from hypothesis import given
from hypothesis import strategies as st

from deburr.expand import Budget, Expansion, Inputs, Job, Program, drive, expand, interpreter
from deburr.expand.job import SLICE
from deburr.ruleset import RuleSet
from deburr_grammar.document import Document
from support.cgt import DIALECT, expanded
from support.pages import MemoryHost

RULES = RuleSet(DIALECT, {"input": "part.cl"})


class Nowhere:
    """Lines that nobody wants."""

    def line(self, text: str) -> None:
        """Nothing."""


@pytest.mark.parametrize(
    ("lines", "row", "said"),
    [
        ("#GOTO(START)", 2, "reached by `#GOTO`"),
        ("#CALL(a)\n@\n@a\n#GOTO(b)\n@\n@b\nA\n#GOTO(a)", None, "lines were executed"),
        ("#CALL(a)\n@\n@a\n#CALL(b)\n@\n@b\n#CALL(a)", None, "64 are the limit"),
        ("#REPEAT(100000)<#REPEAT(100000)<#EVAL(#V1=#V1+1)>>", 2, "of 100,000 of `#REPEAT(100000)` in line 2"),
        ("#REPEAT(100000)<\n#REPEAT(100000)<\nA\n>\n>", 4, "more than 20,000 lines"),
        ("#REPEAT(99999)<\n#CALL(a)\n>\n@\n@a\n#REPEAT(99999)<>", 7, "`#REPEAT(99999)` in line 7"),
        (
            "#REPEAT(99999)<#REPEAT(99999)<0123456789012345678901234567890123456789>>",
            2,
            "one line of more than 1,000,000 characters",
        ),
        ("#EVAL(#V1=10^12)\n#REPEAT(#V1)<A>", 3, "100,000 are the limit"),
        ("#EVAL(#V1=2)\n#REPEAT(100000)<#EVAL(#V1=#V1*#V1)>", 3, "no finite number"),
    ],
)
def test_what_has_no_end_ends_with_the_budget(lines: str, row: int | None, said: str) -> None:
    tracemalloc.start()
    try:
        found = expanded(f"@START\n{lines}\n@", "FINI", budget=Budget(60_000, 20_000))
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    fault = found.faults[-1]
    assert fault.kind in ("limit", "math") and said in fault.message, fault.message
    assert row is None or fault.line + 1 == row
    assert fault.stack is not None and peak < 30_000_000


def test_a_word_that_needs_itself_is_a_recursion() -> None:
    found = expanded("@DECLARE\n#CALCDEC #a\n@\n@$a\n#RETNUM(#a+1)\n@\n@START\n#a\n@", "FINI")
    assert [(fault.kind, fault.line + 1) for fault in found.faults] == [("limit", 5)]


@pytest.mark.parametrize(("calls", "kinds"), [(64, []), (65, ["limit"])])
def test_calls_may_be_64_deep(calls: int, kinds: list[str]) -> None:
    sections = "\n".join(f"@s{number}\n#CALL(s{number + 1})\n@" for number in range(1, calls))
    found = expanded(f"@START\n#CALL(s1)\n@\n{sections}\n@s{calls}\nA\n@", "FINI")
    assert [fault.kind for fault in found.faults] == kinds
    assert found.lines == ([] if kinds else ["A"])


@pytest.mark.parametrize(("length", "kinds"), [(254, []), (255, ["string-length"])])
def test_a_word_holds_254_characters(length: int, kinds: list[str]) -> None:
    found = expanded("@START\n#EVAL(#S1=#FILE)\n#S1\n@", f"PARTNO {'A' * length}\nFINI")
    assert [fault.kind for fault in found.faults] == kinds
    assert found.lines == ([] if kinds else ["A" * length])


@pytest.mark.parametrize(
    ("lines", "passes"),
    [("#REPEAT(100000)<#EVAL(#V1=#V1+1)>", 100_000), ("#REPEAT(90000)<\n#EVAL(#V1=#V1+1)\n>", 180_000)],
)
def test_a_run_is_left_every_so_many_lines(lines: str, passes: int) -> None:
    host = MemoryHost({"part.cl": "FINI"})
    document = Document.parse(f"@START\n{lines}\n@", DIALECT)
    job = Job((Program("main.cgt", document),), RULES, host, Nowhere(), Inputs(), Budget(0, 0))
    slices = sum(1 for _ in drive(job))
    assert passes <= job.steps <= passes + 10
    assert slices >= passes // SLICE


def test_a_long_toolpath_is_left_too() -> None:
    host = MemoryHost({"part.cl": "FEDRAT/100\n" * 10_000})
    job = Job(
        (Program("main.cgt", Document.parse("@START\n@", DIALECT)),), RULES, host, Nowhere(), Inputs(), Budget(0, 0)
    )
    assert sum(1 for _ in drive(job)) >= 10_000 // SLICE


def test_lines_do_not_gather_in_memory() -> None:
    host = MemoryHost({"part.cl": "FINI"})
    document = Document.parse("@START\n#REPEAT(50000)<\n#V1#EVAL(#V1=#V1+1)\n>\n@", DIALECT)
    job = Job((Program("main.cgt", document),), RULES, host, Nowhere(), Inputs(), Budget(0, 0))
    for _ in zip(range(4), drive(job)):
        continue
    tracemalloc.start()
    try:
        for _ in drive(job):
            continue
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert job.emitted >= 50_000 and peak < 2_000_000


def test_what_is_worth_running() -> None:
    worth = interpreter("cgt").worth_running
    assert worth(Document.parse("@START\nX#V1\n@", DIALECT))
    assert worth(Document.parse("@START\n#REPEAT(2)<A>\n@", DIALECT))
    assert not worth(Document.parse("@START\n%\nG90 <G0>\n@", DIALECT))
    assert not worth(Document.parse("text with #V1 and no section", DIALECT))


FRAGMENTS = (
    "X#XPOS", "#V1", "#S1", "#MOV", "#NOPE", "#myX", "#DATE", "#side", "<", ">", "#ELSE<", "#OR", "#AND", "#EXC", "#IF(#V1>0)<", "#IF(#S1>",
    "#IFCHG(#XPOS)<", "#IFSTR(#S1=)<", "#REPEAT(2)<", "#REPEAT(#V1)", "\n", "\n", "\n", "@LINE\n", "@\n", "@START\n", "@a\n", "@$side\n", "@DECLARE\n",
    "#CALL(a)", "#CALL(LINE)", "#GOTO(a)", "#EXIT", "#EXITC", "#CALL(t)", "@t\n0,A\n", "#TABLE(t,1)", "#TABLE(a,0)", "#EVAL(#V1=#V1+1)", "#EVAL(#V1=M03)",
    "#EVAL(#S1=#V1)", "#EVAL(3=1)", "#EVAL(#ON=1)", "#EVAL(#V1=FOO(1))", "#EVAL(#V1=MAX(1))", "#EVAL(#V1=)", "#EVAL(#V1=1/0)", "#EVAL(#S1=STRSUB(#S1,0,1))",
    "#FMT(#V1,D3.4)", "#FMT(#V1,Q3)", "#FMT(#V1,D9.9999999)", "#FMT(#F_Decimal,T!2.0,3)", "#RESET(#XPOS)", "#UPDATE(#XPOS,#V1)", "#GETBLK(1)", "#SETBLK(1)",
    "#ONBLK", "#RETNUM(1)", "#RETSTR(A)", "#CALCDEC #side", "#CALCSTR #side", "#DEC #mine", "#EVMD(#x=1)", "#EVMS(#x=A)", "// c", " ", "text", "#", "JOS(A)",
    "#EVAL(#V1=JOS(A))", "#EVAL(#V1=TLEN(1)+TOTEL())", "#REPEAT(1.5)<", "#BLK", "#FEED",
)  # fmt: skip
CL = (
    "GOTO/1,2,3",
    "GOTO/4,5",
    "RAPID",
    "CIRCLE/0,0,0,0,0,1,5",
    "CYCLE/DRILL",
    "CYCLE/OFF",
    "LOADTL/1",
    "FEDRAT/9",
    "SPINDL/OFF",
    "FROM/1,1,1",
    "WHAT/1",
    "DELAY/1",
    "FINI",
)


@given(st.lists(st.sampled_from(FRAGMENTS), max_size=30), st.lists(st.sampled_from(CL), max_size=8))
def test_no_template_makes_a_run_fail(parts: list[str], statements: list[str]) -> None:
    """Rules that would have stopped it may be off: then the run stops itself, at a place that there is."""
    found = ran("".join(["@START\n", *parts]), "\n".join(statements))
    for fault in found.faults:
        assert RULES.named(fault.kind) is not None, fault.kind
        assert fault.message


@given(st.lists(st.sampled_from(FRAGMENTS), max_size=12))
def test_a_run_gives_the_same_twice(parts: list[str]) -> None:
    text = "".join(["@LINE\n", *parts])
    one, two = ran(text, "GOTO/1,2,3\nGOTO/1,3,3"), ran(text, "GOTO/1,2,3\nGOTO/1,3,3")
    assert one.lines == two.lines
    assert [fault[:5] for fault in one.faults] == [fault[:5] for fault in two.faults]


def ran(text: str, toolpath: str) -> Expansion:
    host = MemoryHost({"part.cl": toolpath})
    return expand([Program("main.cgt", Document.parse(text, DIALECT))], RULES, host, None, Budget(2_000, 2_000))
