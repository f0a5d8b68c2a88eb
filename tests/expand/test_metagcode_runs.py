"""MetaGCODE: the trigger of every rule that a run decides, what a run says in `check`, and runs that must be stopped."""

import tracemalloc
from collections.abc import Mapping, Sequence

import pytest

from deburr.analysis import Analysis
from deburr.expand import Budget, Inputs, Job, Program, drive, expand
from deburr.host import Host, NoFiles
from deburr.ran import Misgiven, ran
from deburr.ruleset import RuleSet
from deburr_grammar.document import Document
from support.metagcode import DIALECT, RULES, expanded, flat
from support.pages import MemoryHost


def found(
    program: str,
    files: Mapping[str, str] | None = None,
    file: str = "main.mgc",
    host: Host | None = None,
    define: Mapping[str, str] | None = None,
    **settings: str,
) -> list[str]:
    """What `check` says with a run: rules and places, `loop-zero main.mgc 1 7-10`."""
    document = Document.parse(program, DIALECT)
    inputs = Inputs(define or {})
    analysis = Analysis(
        document, RuleSet(DIALECT, settings), file, host or MemoryHost(files or {}), run=ran, inputs=inputs
    )
    return [
        f"{each.rule.removeprefix('metagcode.')} {each.place.file} {each.place.line + 1} {each.place.col}-{each.place.end_col}"
        for each in analysis.findings()
    ]


USE = "G1 Z|z|\n#ENDLOOP1"
RUN_TIME = [
    ("loop-zero", 1, "7-10", f"#LOOP1 |z| 2 c\n{USE}", {"z": "0"}),
    ("not-numeric", 1, "7-10", f"#LOOP1 |z| 2 c\n{USE}", {"z": "1e9"}),
    ("not-numeric", 1, "5-8", "#IF1 |a| equalto 1 n\n#ENDIF1", {"a": "Steel"}),
    ("not-numeric", 1, "17-20", "#IF1 1 lessthan  |a| n\n#ENDIF1", {"a": ""}),
    ("loop-step-zero", 1, "11-14", f"#LOOP1 |z| |s| c\n{USE}", {"z": "0", "s": "0.0"}),
    ("loop-step-negative", 1, "11-14", f"#LOOP1 |z| |s| c\n{USE}", {"z": "4", "s": "-2"}),
    ("limit", 1, "7-10", f"#LOOP1 |z| .001 c\n{USE}", {"z": "1000000000"}),
    ("alpha-case", 1, "5-24", "#IF1 |m| equalto   Steel a\n#ENDIF1", {"m": "steel"}),
    ("double-sign", 1, "5-8", "G1 Z-|z| F|f|", {"z": "-1.6", "f": "-5"}),
    ("double-sign", 2, "5-8", "#LOOP1 |z| 2 c\nG1 Z-|z|\n#ENDLOOP1", {"z": "-4"}),
    ("double-sign", 2, "6-9", "#LOOP1 |z| 2 r\nG1 Z+ |z|\n#ENDLOOP1", {"z": "-4"}),
    ("double-sign", 1, "8-11", "G1 X2 Y |s||y|", {"s": "-", "y": "+1"}),
    ("double-sign", 1, "4-7", "G1 X|x| (-)", {"x": "--5"}),
    ("alpha-number", 1, "5-23", "#IF1 |t| greaterthan 10 a\n#ENDIF1", {"t": "9"}),
]


@pytest.mark.parametrize(("rule", "line", "cols", "program", "define"), RUN_TIME)
def test_each_trigger_that_a_run_decides_gives_its_rule_and_no_other(
    rule: str, line: int, cols: str, program: str, define: Mapping[str, str]
) -> None:
    assert found(program, define=define) == [f"{rule} main.mgc {line} {cols}"]


@pytest.mark.parametrize(
    ("define", "said"),
    [({"a": "1|2"}, "has a bar in it"), ({"b": "3", "a": "|"}, "has a bar"), ({"a": "1\r2"}, "has a line end in it")],
)
def test_a_value_that_no_program_can_use_is_no_fault_of_a_program(define: Mapping[str, str], said: str) -> None:
    for program in ("G0 X0\n(no |a|)", "G0 X0\n(|b|)"):
        with pytest.raises(Misgiven, match=f"^-D a=...: the value {said}"):
            found(program, define=define)


@pytest.mark.parametrize(
    "line",
    [
        "G1 Z|z|", "(down to Z-|z|)", "G0 ; Z-|z|", 'MSG "Z-|z|"', "#1=X-|z|", "HA<X-|z|>", "G1 X[X-|z|]", "!HA=X-|z|!", "G1 X5-|z|", "DEPTH-|z|",
        "G1 Z--5 X|z|", "G1 Z--|plus|", "G1 X-|plus| Z|z|", "G1 X1-|z|", "N10 (a) (Z-|z|)",
    ],
)  # fmt: skip
def test_two_signs_are_wrong_only_where_a_word_has_its_number(line: str) -> None:
    define = {"z": "-1.6", "plus": "3"}
    assert found(line, define=define) == []
    assert flat(line, define=define) == [line.replace("|z|", "-1.6").replace("|plus|", "3")]


def test_limits_are_the_last_legal_values() -> None:
    loop = f"#LOOP1 |z| 0.001 c\n{USE}"
    assert found(loop, define={"z": "100"}) == []
    assert found(loop, define={"z": "100.0001"}) == ["limit main.mgc 1 7-10"]
    small = {"small.txt": "G0 " + "X" * ((1 << 20) - 3)}
    assert [fault.kind for fault in expanded("#FILE small.txt", files=small).faults] == ["line-too-long"]
    assert [fault.kind for fault in expanded("#FILE s", files={"s": "G0\n" * 349_525 + "G\n"}).faults] == ["limit"]
    assert expanded("#FILE s", files={"s": "G0\n" * 349_525 + "G"}).faults == ()
    deep = (
        "".join(f"#IF{at} a equalto a a\n" for at in range(200)),
        "".join(f"#ENDIF{at}\n" for at in range(199, -1, -1)),
    )
    assert flat(f"{deep[0]}M8\n{deep[1]}") == ["M8"]
    deeper = expanded("#IF200 a equalto a a\n" + deep[0] + deep[1] + "#ENDIF200")
    assert [(fault.kind, fault.line) for fault in deeper.faults] == [("limit", 200)]
    chain = {f"{at}": f"#FILE {at + 1}" for at in range(1, 20)}
    assert flat("#FILE 1", files={**chain, "20": "M8"}) == ["M8"]
    too_deep = expanded("#FILE 1", files={**chain, "20": "#FILE 21", "21": "M8"})
    assert [(fault.kind, fault.file) for fault in too_deep.faults] == [("snippet-depth", "Snippets/20")]


ONCE = "#FILE 1\n" * 6
FAN = {f"{at}": f"#FILE {at + 1}\n" * 6 for at in range(1, 20)}
LOOPS = "#LOOP1 |n| 1 c\n#LOOP2 |z| .001 c\n#ENDLOOP2\n#ENDLOOP1"
ENDLESS: Sequence[tuple[str, str, Mapping[str, str], str, str]] = [
    ("steps", LOOPS, {}, "2:limit", "last in pass 99,999 of 100,000 of `#LOOP2` with `|z|` = `99.999`"),
    ("fan", ONCE, {**FAN, "20": "M8"}, "0:limit", "1,000,000 lines"),
    ("cycle", "#FILE a", {"a": "G0\n#FILE b", "b": "#FILE a"}, "0:snippet-cycle", "`a` > `b` > `a`"),
    ("itself", "#FILE a", {"a": "#IF1 a equalto b a\n#FILE a\n#ENDIF1"}, "1:snippet-cycle", "`a` > `a`"),
    (
        "passes",
        "#LOOP1 |z| 0.0000000000001 c\nG0\n#ENDLOOP1",
        {},
        "0:limit",
        "1,000,000,000,000,000 passes",
    ),
]


@pytest.mark.parametrize(("name", "program", "files", "at", "words"), ENDLESS, ids=[each[0] for each in ENDLESS])
def test_what_never_ends_is_stopped_where_it_stands(
    name: str, program: str, files: Mapping[str, str], at: str, words: str
) -> None:
    tracemalloc.start()
    try:
        expansion = expanded(program, files=files, define={"z": "100", "n": "50"}, budget=Budget(100_000))
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    fault = expansion.faults[-1]
    assert f"{fault.line}:{fault.kind}" == at and words in fault.message
    assert peak < 50_000_000


def test_all_loops_together_make_a_million_passes() -> None:
    budget = Budget(0, 0)
    fault = expanded(LOOPS, define={"z": "100", "n": "10"}, budget=budget).faults[-1]
    assert (fault.kind, fault.line) == ("limit", 1)
    assert "1,000,000 passes, last in pass 99,990 of 100,000 of `#LOOP2`" in fault.message


def test_files_that_come_to_nothing_cost_nothing() -> None:
    assert flat(ONCE, files={**FAN, "20": ""}) == []


def test_a_run_is_left_every_two_thousand_lines_and_keeps_no_line() -> None:
    text = "#LOOP1 |z| .001 c\nG1 Z|z| (a line that is long enough to be noticed if it were kept)\n#ENDLOOP1"

    class Sink:
        def line(self, text: str) -> None:
            pass

    job = Job([Program("", Document.parse(text, DIALECT))], RULES, NoFiles(), Sink(), Inputs({"z": "40"}))
    tracemalloc.start()
    try:
        slices = sum(1 for _ in drive(job))
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert job.emitted == 40_000 and slices >= 40
    assert peak < 1_000_000


def test_a_run_that_lacks_an_input_ends_in_silence() -> None:
    assert found("G0 X|nope|\n#LOOP1 |z| 2 c\nZ|z|\n#ENDLOOP1", define={"z": "0"}) == []
    assert found("#LOOP1 |z| 2 c\nZ|z|\n#ENDLOOP1\nG0 X|nope|", define={"z": "0"}) == ["loop-zero main.mgc 1 7-10"]
    assert found("#FILE peck.txt\n#LOOP1 |z| 2 c\nZ|z|\n#ENDLOOP1", host=NoFiles(), define={"z": "0"}) == []


def test_a_snippet_that_is_run_by_itself_proves_nothing() -> None:
    peck = "#LOOP1 |Z| 2 c\nG1 Z|Z|\n#ENDLOOP1\n"
    files = {"Snippets/peck.txt": peck}
    assert found(peck, files, "Snippets/peck.txt", define={"Z": "0"}) == []
    assert found(peck, files, "main.mgc", define={"Z": "0"}) == ["loop-zero main.mgc 1 7-10"]


def test_what_a_run_meets_in_a_snippet_is_reported_there_with_the_way_to_it() -> None:
    program = "#LOOP1 |n| 1 c\n#FILE peck.txt\n(|n|)\n#ENDLOOP1"
    files = {"Snippets/peck.txt": "#LOOP1 |Z| 2 c\nG1 Z|Z|\n#ENDLOOP1"}
    inputs = Inputs({"Z": "0", "n": "3"})
    analysis = Analysis(Document.parse(program, DIALECT), RULES, "main.mgc", MemoryHost(files), run=ran, inputs=inputs)
    (finding,) = analysis.findings()
    assert (finding.rule, finding.place[:3]) == ("metagcode.loop-zero", ("Snippets/peck.txt", 0, 7))
    assert [(each.place.file, each.place.line) for each in finding.related] == [("main.mgc", 1), ("main.mgc", 0)]


def test_a_run_sees_what_no_rule_of_the_program_itself_sees_in_its_snippets() -> None:
    files = {"Snippets/a.txt": "#FILE b.txt\n", "Snippets/b.txt": "G0\n#FILE nothere.txt\n"}
    assert found("#FILE a.txt", files) == ["file-missing Snippets/b.txt 2 6-17"]
    files["Snippets/b.txt"] = "#IF1 |a| = 1 n\nG0\n#ENDIF1\n"
    assert found("#FILE a.txt", files) == ["if-operator Snippets/b.txt 1 9-10"]


def test_a_program_without_meta_constructs_is_not_run() -> None:
    from deburr.expand import metagcode

    assert not metagcode.worth_running(Document.parse("G0 X1\n#3=6\n(no)", DIALECT))
    for text in ("G0 X|a|", "#FILE a", "#IF1 a equalto a a\n#ENDIF1"):
        assert metagcode.worth_running(Document.parse(text, DIALECT))


def test_a_rule_that_is_switched_off_does_not_make_a_line_runnable() -> None:
    rules = RuleSet(DIALECT, None, lambda rule: rule.short != "if-operator")
    document = Document.parse("#IF1 |a| = 1 n\nM8\n#ENDIF1", DIALECT)
    expansion = expand([Program("a.mgc", document)], rules, NoFiles(), Inputs({"a": "1"}))
    assert [fault.kind for fault in expansion.faults] == ["if-operator"] and not expansion.lines
    assert Analysis(document, rules, "a.mgc", run=ran).findings() == []
