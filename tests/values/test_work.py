"""How often routines are gone through until a program's values are known: as seldom as what they call and are called with allows."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any, NamedTuple

import pytest

from deburr.values import values_of
from deburr.values.graph import Calls, Env, Flows, Graph, Node, join
from deburr.values.kept import Kept
from deburr.values.metagcode import flow
from deburr.values.solve import Solution
from deburr.values.z32.expressions import World
from deburr.values.z32.flow import Builder
from deburr.values.z32.made import Made
from deburr.values.z32.made import made as lines_made
from deburr_grammar.line import LineNode
from support.values import analysed

MANY = 39
"""Sections, each of which is called three times, every time with another value."""
MAINS = {"z32": ("(P)\n", "HA{at}\n!GOP{part}!\n", "M30\n"), "rs274": ("", "#31={at}\no<s{part}> call\n", "M2\n")}
"""The main programs: a line that sets what the sections read, and a call, many times."""
PARTS = {
    "z32": ":{at}\nHB0\nN10 X<HB+HA>\n!HB=HB+1; IF HB<9; GON10!\nHC<HA>\nG26\n",
    "rs274": "o<s{at}> sub\n#32=0\no1 while [#32 LT 9]\n#32=[#32+1]\no1 endwhile\n#33=#31\no<s{at}> endsub\n",
}
EDITS = {"z32": ("X<HB+HA>", "X<HB+HA*2>"), "rs274": ("LT 9]", "LT 8]")}
"""What is edited in one section. What it leaves is the same in Z32; in RS274 its caller goes on with something else, and calls the next one with that."""
SAME = {"z32": EDITS["z32"], "rs274": ("#33=#31", "#33=[#31*1]")}
"""Edits behind which a section leaves what it left before."""
TOUCHED = {"z32": ["main.ngc:21"], "rs274": ["main program", "s21", "s22"]}
LOOPS = {
    "z32": "(P)\nHA0\nHB0\nN10 X<HA>\n!HA=HA+1; IF HA<9000; GON10!\nHB<HA>\nHC<HB>\nX<HC>\n",
    "rs274": "#1=0\no1 while [#1 LT 9000]\n#1=[#1+1]\no1 endwhile\n#2=#1\n#3=#2\n#4=#3\n",
}
"""A loop that counts far, and three lines behind it."""
ROUNDS = 2
"""A section is gone through where it is first called, and once more with all that is passed."""


def _text(dialect: str, edited: tuple[str, str] = ("", ""), many: int = MANY) -> str:
    parts = [PARTS[dialect].format(at=at) for at in range(1, many + 1)]
    parts[many // 2 + 1] = parts[many // 2 + 1].replace(*edited)
    main = _main(dialect, many)
    return "".join((main, *parts)) if dialect == "z32" else "".join((*parts, main))


def _main(dialect: str, many: int) -> str:
    first, each, last = MAINS[dialect]
    return first + "".join(each.format(at=at, part=at % many + 1) for at in range(3 * many)) + last


def _work(dialect: str, text: str, monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """How often each routine is gone through."""
    made: list[Graph] = []

    class Counted(Solution):
        def __init__(self, graph: Graph, *more: Any) -> None:
            made.append(graph)
            super().__init__(graph, *more)

    with monkeypatch.context() as patch:
        patch.setattr("deburr.values.ledger.Solution", Counted)
        found = values_of(analysed(text, dialect))
    assert found is not None
    names = {id(routine.graph): name for name, routine in found.routines.items()}
    return Counter(names[id(graph)] for graph in made)


@pytest.mark.parametrize("dialect", MAINS)
def test_a_routine_is_gone_through_once_for_all_further_calls(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("deburr.values.ledger._kept", Kept[Any]())
    first = _work(dialect, _text(dialect), monkeypatch)
    assert len(first) == MANY + 1
    # What the last section leaves comes round to the first ones, whose answers may send one more round to it.
    assert first["main program"] <= ROUNDS and sum(first.values()) <= ROUNDS * (MANY + 1) + 1, first
    edit = _work(dialect, _text(dialect, EDITS[dialect]), monkeypatch)
    assert sorted(edit) == TOUCHED[dialect]
    assert max(edit.values()) <= ROUNDS, edit


@pytest.mark.parametrize("dialect", MAINS)
def test_what_routines_are_called_with_is_joined_again_where_an_edit_changes_it(
    dialect: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is the same work whether a program has few routines or many, for all others start with what they started with."""
    joined = []
    for many in (MANY // 2, MANY):
        monkeypatch.setattr("deburr.values.ledger._kept", Kept[Any]())
        made: list[Env] = []

        def counted(one: Env, two: Env, made: list[Env] = made) -> Env:
            made.append(one)
            return join(one, two)

        monkeypatch.setattr("deburr.values.program.join", counted)
        for edit in (("", ""), SAME[dialect]):
            made.clear()
            assert values_of(analysed(_text(dialect, edit, many), dialect)) is not None
        joined.append(len(made))
    assert joined[0] == joined[1] < 20, joined


def test_behind_an_edit_the_flow_of_its_section_is_made_again_of_what_its_lines_were_made(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is the same work whether a program has few sections or many: the nodes of one, and what one line says."""
    for many in (MANY // 2, MANY):
        nodes: list[int] = []
        lines: list[str] = []
        add, made = Builder.add, Made.__init__

        def added(
            self: Builder, number: int, *more: Any, add: Any = add, nodes: list[int] = nodes, **named: Any
        ) -> None:
            nodes.append(number)
            add(self, number, *more, **named)

        def making(self: Made, world: World, node: LineNode, made: Any = made, lines: list[str] = lines) -> None:
            lines.append(node.text)
            made(self, world, node)

        with monkeypatch.context() as patch:
            patch.setattr("deburr.values.ledger._kept", Kept[Any]())
            patch.setattr("deburr.values.z32.split._graphs", Kept[Any]())
            patch.setattr(Builder, "add", added)
            patch.setattr(Made, "__init__", making)
            lines_made.cache_clear()
            assert values_of(analysed(_text("z32", many=many), "z32")) is not None
            assert len(nodes) > 8 * many and len(lines) < len(nodes)
            nodes.clear()
            lines.clear()
            assert values_of(analysed(_text("z32", EDITS["z32"], many), "z32")) is not None
        assert (nodes, lines) == (list(range(8)), ["N10 X<HB+HA*2>"]), many


@pytest.mark.parametrize("dialect", LOOPS)
def test_what_is_behind_a_loop_is_gone_through_once(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits for what the loop really leaves, after the resting places of its values are forgotten."""
    asked: Counter[int] = Counter()
    passed, went_on = Solution._pass, Solution._go_on

    def counted_pass(self: Solution, node: int, env: Env | None) -> None:
        asked[self.graph.nodes[node].line] += 1
        passed(self, node, env)

    def counted_going(self: Solution, node: int, here: Node, change: Callable[[Env], Env], env: Env) -> Env | None:
        before = asked.total()
        found = went_on(self, node, here, change, env)
        asked[here.line] += asked.total() == before
        return found

    monkeypatch.setattr(Solution, "_pass", counted_pass)
    monkeypatch.setattr(Solution, "_go_on", counted_going)
    monkeypatch.setattr("deburr.values.ledger._kept", Kept[Any]())
    text = LOOPS[dialect]
    assert values_of(analysed(text, dialect)) is not None
    last = max(asked)
    assert asked[2] > 1 and [asked[line] for line in range(last - 2, last + 1)] == [1, 1, 1], asked


class Counts(NamedTuple):
    """The lines of which nodes were made, and those whose conditions were looked at again; how many nodes values were sent through."""

    made: list[str]
    asked: list[str]
    passed: list[int]


def _counted(text: str, monkeypatch: pytest.MonkeyPatch) -> Counts:
    found = Counts([], [], [])
    new_node, passed = flow._new_node, Solution._pass

    def counted(line: LineNode, *more: Any) -> Node:
        found.made.append(line.text)
        node = new_node(line, *more)

        def counted_flow(env: Env, calls: Calls) -> Flows:
            asked.append(line.text)
            return node.flow(env, calls)

        return node._replace(flow=counted_flow)

    def counted_pass(self: Solution, node: int, env: Env | None) -> None:
        found.passed.append(node)
        passed(self, node, env)

    with monkeypatch.context() as patch:
        patch.setattr(flow, "_new_node", counted)
        patch.setattr(Solution, "_pass", counted_pass)
        asked.clear()
        assert values_of(analysed(text, "metagcode")) is not None
    found.asked.extend(asked)
    return found


asked: list[str] = []
"""What is asked of nodes that outlive a text is told here."""


def _forget(monkeypatch: pytest.MonkeyPatch) -> None:
    """No text was ever seen."""
    flow._node.cache_clear()
    flow._made.cache_clear()
    for place in ("ledger._kept", "ledger._latest", "metagcode.flow._graphs"):
        monkeypatch.setattr(f"deburr.values.{place}", Kept[Any]())


def _asking(many: int, first: int = 1) -> str:
    return "".join(
        f"#IF{at} |Depth| greaterthan {at if at > 1 else first} numeric\nG1 X-|Depth|\n#ENDIF{at}\n"
        for at in range(1, many)
    )


@pytest.mark.parametrize("many", [MANY, 2 * MANY])
def test_a_text_is_gone_through_again_where_it_is_edited(many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a line far from the edit says, and the values that come there, are what they were: however long the text is."""
    _forget(monkeypatch)
    first = _counted(_asking(many), monkeypatch)
    assert len(first.made) == len(first.asked) == len(first.passed) == 3 * (many - 1)
    edit = _counted(_asking(many, first=2), monkeypatch)
    lines = ["#IF1 |Depth| greaterthan 2 numeric", "G1 X-|Depth|", "#ENDIF1"]
    assert edit == (lines[:1], lines, [0, 1, 2])


def test_a_line_more_has_nothing_else_made_or_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    _forget(monkeypatch)
    text = _asking(MANY)
    _counted(text, monkeypatch)
    more = _counted(f"G1 Y-|Depth|\n{text}", monkeypatch)
    assert (more.made, more.asked) == (["G1 Y-|Depth|"], ["G1 Y-|Depth|"])
