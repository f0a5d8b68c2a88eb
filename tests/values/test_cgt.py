"""CGT: what is proven of words at each command, what is not, and what an edit costs (spec/cgt.md §5)."""

import re
from collections.abc import Generator, Mapping
from pathlib import Path
from typing import Any

import pytest

from deburr.analysis import Analysis
from deburr.finding import Finding, Severity
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr.values import proving, values_of
from deburr.values.cgt.flow import Builder, Section
from deburr.values.cgt.generator import NAME as GENERATOR
from deburr.values.graph import Graph
from deburr.values.solve import Solution
from deburr.values.words import said
from deburr_grammar.document import Document
from support.cgt import DIALECT
from support.pages import MemoryHost
from support.values import analysed

ROOT = Path(__file__).parents[2]
MAIN = "main.cgt"
RULES, LISTED = RuleSet(DIALECT), RuleSet(DIALECT, {"input": "part.jsonl"})


FRAME = "@DECLARE\n#INT #n,#count\n#STR #kind\n#TBL #gear\n#CALCDEC #half\n@\n@$half\n#RETNUM(#V9/2)\n@\n@gear\n0,M41\n1,M42\n@\n@LINE\n"
MEANT: dict[str, tuple[str, str, str]] = {
    "a constant": ("#EVAL(#V1=2*5)\n#here", "V1", "10"),
    "what the toolpath sets": ("#EVAL(#V1=#XPOS)\n#here", "V1", ""),
    "what a section sets of that": ("#EVAL(#FEED=5)\n#EVAL(#V1=#FEED*2)\n#here", "V1", "10"),
    "a word that nothing sets, which is given from outside": ("#here", "V1", ""),
    "a word that is set behind the place at first, and then before it": ("#here\n#EVAL(#V1=3)", "V1", "0 … 3 step 3"),
    "a counter": ("#EVAL(#V1=#V1+1)\n#here", "V1", "at least 1"),
    "a counter that stops somewhere": ("#IF(#V1<10)<#EVAL(#V1=#V1+1)>\n#here", "V1", "at least 1"),
    "a branch": ("#IF(#XPOS>0)<#EVAL(#V1=1)>#ELSE<#EVAL(#V1=4)>\n#here", "V1", "1 … 4 step 3"),
    "a condition": ("#EVAL(#V1=#XPOS)\n#IF(#V1>2)<#here>", "V1", "above 2"),
    "a condition that does not hold": ("#EVAL(#V1=#XPOS)\n#IF(#V1>2)<M08>#ELSE<#here>", "V1", "at most 2"),
    "two conditions at once": ("#EVAL(#V1=INT(#XPOS))\n#IF(#V1>2,#AND#V1<=9)<#here>", "V1", "3 … 9, integers"),
    "one of two conditions": ("#EVAL(#V1=INT(#XPOS))\n#IF(#V1<=2,#OR#V1>9)<M08>#ELSE<#here>", "V1", "3 … 9, integers"),
    "that it is not 0": ("#EVAL(#V1=#XPOS)\n#IF(#V1<>0)<#here>", "V1", "never 0"),
    "what counts as equal": ("#EVAL(#V1=#XPOS)\n#IF(#V1=0)<#here>", "V1", "0"),
    "a remainder with the sign of the dividend": ("#EVAL(#V1=MOD(#XPOS,6))\n#here", "V1", "-5 … 5, integers"),
    "a root": ("#EVAL(#V1=SQR(#XPOS))\n#here", "V1", "at least 0"),
    "the greater of two": ("#EVAL(#V1=MAX(3,#XPOS))\n#here", "V1", "at least 3"),
    "a rounded value": ("#EVAL(#V1=RND(SIN(#XPOS),0))\n#here", "V1", "-1 … 1, integers"),
    "a sign": ("#EVAL(#V1=SGN(#XPOS)+5)\n#here", "V1", "4 … 6, integers"),
    "a loop": ("#EVAL(#V1=0)\n#REPEAT(3)<\n#EVAL(#V1=#V1+2)\n>\n#here", "V1", "at least 2"),
    "a loop that may have no pass": ("#EVAL(#V1=7)\n#REPEAT(#V2)<\n#EVAL(#V1=9)\n>\n#here", "V1", "7 … 9 step 2"),
    "a count of passes": ("#EVAL(#V2=#XPOS)\n#REPEAT(#V2)<\n#here\n>", "V2", "0 … 100001"),
    "a called section": ("#EVAL(#V1=1)\n#CALL(a)\n#here\n@\n@a\n#EVAL(#V1=#V1+1)", "V1", "at least 1"),
    "a word that a called section leaves alone": ("#EVAL(#V1=1)\n#CALL(a)\n#here\n@\n@a\n#EVAL(#V2=5)", "V1", "1"),
    "behind a section that may leave its caller": (
        "#EVAL(#V1=1)\n#CALL(a)#EVAL(#V1=2)\n#here\n@\n@a\n#IF(#XPOS>0)<#EXITC>", "V1", "1 … 2, integers",
    ),
    "behind a section that ends everything": (
        "#EVAL(#V1=1)\n#IF(#XPOS>0)<\n#EVAL(#V1=2)\n#CALL(a)\n>\n#here\n@\n@a\n#EXIT", "V1", "1",
    ),
    "a computed word": ("#EVAL(#V9=8)\n#EVAL(#V1=#half+1)\n#here", "V1", "5"),
    "texts": ("#IF(#XPOS>0)<#EVAL(#S1=M03)>#ELSE<#EVAL(#S1=M04)>\n#here", "S1", '"M03" or "M04"'),
    "a text that is asked for": (
        "#IF(#XPOS>0)<#EVAL(#S1=M03)>#ELSE<#EVAL(#S1=M04)>\n#IFSTR(#S1=M03)<M08>#ELSE<#here>", "S1", '"M04"',
    ),
    "a part of a text": ("#EVAL(#S1=ABCDE)\n#EVAL(#S2=STRSUB(#S1,2,3))\n#here", "S2", '"BCD"'),
    "the length of a text": ("#EVAL(#S1=ABCDE)\n#EVAL(#V1=STRLEN(#S1))\n#here", "V1", "5"),
    "switches": ("#EVAL(#V1=#ON)\n#here", "V1", "1"),
}  # fmt: skip
"""Lines of `@LINE`, a word, and what it holds where `#here` stands."""


@pytest.mark.parametrize("name", MEANT)
def test_what_a_word_holds(name: str) -> None:
    lines, key, text = MEANT[name]
    program = f"{FRAME}{lines}\n@\n".replace("#here", "#EVAL(#count=1)")
    row = program[: program.index("#EVAL(#count=1)")].count("\n")
    found = values_of(analysed(program, "cgt", path=MAIN))
    assert found is not None
    solution = found.solved["LINE"].solution
    nodes = [number for number, node in found.routines["LINE"].graph.nodes.items() if "count" in node.sets]
    value = solution.before[nodes[0]].get(key)
    assert (said(value) if value is not None else "") == text, (row, value)


SILENT = {
    "a word that nothing sets": "#EVAL(#V1=1/#V2)",
    "what the toolpath gives": "#EVAL(#V1=1/#FEED)",
    "a value that an earlier section may have left": "#EVAL(#V1=1/#V2)\n@\n@RAP\n#EVAL(#V2=#XPOS)",
    "one way of two": "#IF(#XPOS>0)<#EVAL(#V1=0)>#ELSE<#EVAL(#V1=1)>\n#EVAL(#V2=5/#V1)",
    "a division that is never reached": "#EVAL(#V1=0)\n#IF(#V1>0)<#EVAL(#V2=5/#V1)>",
    "a switch": "#EVAL(#V1=0)\n#IF(#V1=1)<M08>",
    "a switch for texts": "#EVAL(#S1=no)\n#IFSTR(#S1=yes)<M08>",
    "a guard": "#EVAL(#V1=ABS(#XPOS))\n#IF(#V1<0)<#EXIT>",
    "a caller of two": "#EVAL(#V1=0)\n#IF(#XPOS>0)<#EVAL(#V1=1)>\n#CALL(a)\n@\n@a\n#EVAL(#V2=1/#V1)",
    "a bracket behind a section that may change its word": "<A#V1 M08>\n#CALL(a)\n<A#V1 M09>\n@\n@a\n#EVAL(#V1=#XPOS)",
    "a bracket behind a format": "<A#XPOS M08>\n#FMT(#F_Decimal,D3.1)\n<A#XPOS M09>",
    "a bracket behind a section with a format of its own": "<A#XPOS M08>\n#CALL(a)\n<A#XPOS M09>\n@\n@a\n#FMT(#F_Decimal,D3.1)\nX#XPOS",
    "a bracket whose word is computed": "<A#half M08>\n<A#half M09>\n#EVAL(#V9=#XPOS)",
    "a bracket behind one way that prints": "#IF(#XPOS>0)<A#XPOS>\n<A#XPOS M09>",
    "a bracket of which one word may change": "A#XPOS\n<A#XPOS#OR B#YPOS M08>",
    "block numbers, which count by themselves": "<A#BLK M08>\n<A#BLK M09>",
    "a count that is one of several": "#EVAL(#n=INT(#XPOS))\n#REPEAT(#n)<M08>",
    "a row that may be there": "#TABLE(gear,#V1)\n#EVAL(#V1=#V1+1)",
    "a table that is not there": "#EVAL(#V1=7)\n#EVAL(#COOLNT=#V1-7)\n#COOLNT",
}


@pytest.mark.parametrize("name", SILENT)
def test_nothing_is_said_of_what_is_not_proven(name: str) -> None:
    assert proven(f"{FRAME}{SILENT[name]}\n@\n") == []


def proven(program: str, events: str = "", define: Mapping[str, str] | None = None) -> list[Finding]:
    """What is proven of a template, in warnings and errors."""
    rules = LISTED if events else RULES
    host, inputs = MemoryHost({"part.jsonl": events}), Inputs(define or {})
    analysis = Analysis(Document.parse(program, DIALECT), rules, MAIN, host, inputs=inputs)
    return [each for each in proving(analysis) if each is not None and each.severity > Severity.INFO]


def test_the_chain_is_told() -> None:
    program = "@START\n#EVAL(#V1=0)\n@\n@LINE\n#CALL(a)\n@\n@a\n#EVAL(#V2=#V1*2)\nX#V2\n#EVAL(#V3=1/#V2)\n@\n"
    (found,) = proven(program)
    assert (found.rule, found.place.line, found.place.col, found.place.end_col) == ("cgt.divide-by-zero", 9, 12, 15)
    assert [(each.place.line, each.message) for each in found.related] == [
        (7, "`#V2` is set here, it holds 0"),
        (4, "called here"),
        (1, "`#V1` is set here, it holds 0"),
    ]


def test_a_fault_at_the_first_run_hides_what_would_come_behind_it() -> None:
    (found,) = proven(f"{FRAME}#EVAL(#V1=1/#V2)\n#EVAL(#V2=5)\n#IF(#V2>6)<M08>\n@\n")
    assert (found.rule, found.place.line) == ("cgt.divide-by-zero", 14)


EVENTS = '{"section": "LINE", "set": {"V2": 3}}\n'


def test_what_a_list_of_events_sets_is_not_known() -> None:
    program = f"{FRAME}#EVAL(#V1=1/#V2)\n#EVAL(#V2=0)\n@\n"
    assert [each.rule for each in proven(program)] == ["cgt.divide-by-zero"]
    assert proven(program, EVENTS) == []


def test_what_is_given_for_a_run_is_what_a_word_holds_at_first() -> None:
    program = f"{FRAME}#EVAL(#V1=1/#V2)\n@\n@END\n#EVAL(#V2=0)\n@\n"
    assert [each.rule for each in proven(program)] == ["cgt.divide-by-zero"]
    assert proven(program, define={"V2": "5"}) == []


def _template_of(text: str) -> str:
    return re.split(r"^-- .* --\n", re.split(r"^-- main\.cgt --\n", text, flags=re.M)[1], flags=re.M)[0]


CASES = [
    path for path in sorted((ROOT / "tests/expand/cases/cgt").glob("*.txtar")) if not path.stem.startswith("fault")
]
EXAMPLES = sorted((ROOT / "examples/cgt").glob("*.cgt"))


@pytest.mark.parametrize("path", [*CASES, *EXAMPLES], ids=lambda path: path.stem)
def test_nothing_is_said_of_templates_that_are_right(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert proven(_template_of(text) if path in CASES else text) == []


SECTIONS = "".join(
    f"@{name}\n#EVAL(#V{at}=0)\n#REPEAT(4)<\n#EVAL(#V{at}=#V{at}+1)\nX#V{at}\n>\n@\n" for at, name in enumerate("abcd")
)
LINE = "@LINE\n#CALL(a)\n#CALL(b)\n@\n"


def _gone_through(text: str, monkeypatch: pytest.MonkeyPatch) -> set[str]:
    """The routines that are gone through."""
    made: list[Graph] = []

    class Counted(Solution):
        def __init__(self, graph: Graph, *more: Any) -> None:
            made.append(graph)
            super().__init__(graph, *more)

    with monkeypatch.context() as patch:
        patch.setattr("deburr.values.ledger.Solution", Counted)
        found = values_of(analysed(text, "cgt", path=MAIN))
    assert found is not None
    return {name for name, routine in found.routines.items() if routine.graph in made}


def test_an_edit_costs_the_section_that_it_touches(monkeypatch: pytest.MonkeyPatch) -> None:
    head = "Of an edit.\n"
    assert _gone_through(f"{head}{LINE}{SECTIONS}", monkeypatch) == {GENERATOR, "LINE", "a", "b", "c", "d"}
    assert _gone_through(f"{head}\n{LINE}{SECTIONS}", monkeypatch) == set()
    edited = SECTIONS.replace("X#V2", "Y#V2")
    assert _gone_through(f"{head}{LINE}{edited}", monkeypatch) == {"c"}


PART = "@s{at}\n#EVAL(#V1={at})\n#REPEAT(4)<\n#EVAL(#V1=#V1+1)\nX#V1\n>\n@\n"
PART_NODES = 8
"""The header, a value, the count of the loop, where it comes round, a value, what is output, whether it comes round, the end."""


def _worked(text: str, monkeypatch: pytest.MonkeyPatch) -> tuple[int, int]:
    """How many nodes are built of sections, and how many those have that are gone through, each time that they are."""
    built: list[int] = []
    solved: list[int] = []
    section = Builder.section

    def counted(self: Builder, *more: Any) -> Generator[None, None, Section]:
        found = yield from section(self, *more)
        built.append(len(found.graph.nodes))
        return found

    class Counted(Solution):
        def __init__(self, graph: Graph, *more: Any) -> None:
            solved.append(len(graph.nodes))
            super().__init__(graph, *more)

    with monkeypatch.context() as patch:
        patch.setattr(Builder, "section", counted)
        patch.setattr("deburr.values.ledger.Solution", Counted)
        assert values_of(analysed(text, "cgt", path=MAIN)) is not None
    return sum(built), sum(solved)


@pytest.mark.parametrize("many", [10, 80])
def test_an_edit_is_as_much_work_whatever_stands_around_the_section(many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Only its nodes are built, and gone through with what `@LINE` passes and with what any section may have left."""
    line = "@LINE\n" + "".join(f"#CALL(s{at})\n" for at in range(many)) + "@\n"
    parts = [PART.format(at=at) for at in range(many)]
    first = line + "".join(parts)
    built, _ = _worked(first, monkeypatch)
    assert built == many * PART_NODES + 1 + many + 1
    edited = first.replace(parts[5], parts[5].replace("X#V1", "Y#V1"))
    assert _worked(edited, monkeypatch) == (PART_NODES, 2 * PART_NODES)


def test_lines_without_words_take_no_part() -> None:
    flat = "G00 X1.0 Y2.5\n" * 5_000
    found = values_of(analysed(f"@LINE\n{flat}#EVAL(#V1=5)\n{flat}X#V1\n@\n", "cgt", path=MAIN))
    assert found is not None and len(found.routines["LINE"].graph.nodes) == 4


def test_text_alone_has_no_values() -> None:
    assert values_of(analysed("@LINE\nG00 <X1.0>\n@\n", "cgt", path=MAIN)) is None
