"""Loops to which the same comes as when they were last gone through are not gone through again, and what is proven is the same."""

from __future__ import annotations

from typing import Any

import pytest
from benchmarks.macros import macros

from deburr.analysis import Analysis
from deburr.values import values_of
from deburr.values.graph import Env, Key
from deburr.values.kept import Kept
from deburr.values.region import Region
from deburr.values.solve import Solution
from support.programs import generated as rs274_program
from support.values import analysed
from support.z32programs import generated as z32_program

SEEDS = 40
MAKERS = {"rs274": rs274_program, "z32": z32_program}
CALLED = {
    "z32": "(P)\nHC1\n!GOP1!\nHC2\n!GOP1!\nX<HC>\nM30\n:1\nHA0\nN10 X<HA>\n!HA=HA+1; IF HA<9; GON10!\nHB<HA+{read}>\nX<HC>\nG26\n",
    "rs274": "o<s> sub\n#1=0\no1 while [#1 LT 9]\n#1=[#1+1]\no1 endwhile\n#2=[#1+{read}]\nG0 X#31\no<s> endsub\n#31=1\no<s> call\n#31=2\no<s> call\nM2\n",
}
"""A subprogram with a loop that is called with two values, which the loop does not read."""
LOOPS = {"z32": ("X<HA>", "X<HA+HC>"), "rs274": ("#1=[#1+1]", "#1=[#1+1*#31/#31]")}
"""A line of the loop, and one in its place that reads what is passed."""
INSIDE = {"z32": (9, "HA", "HC"), "rs274": (3, 1, 31)}
"""A line of the loop, its counter, and what is passed."""


def rounds(analysis: Analysis, monkeypatch: pytest.MonkeyPatch) -> int:
    """How many loops are gone round until the values of a program are known."""
    found: list[Region] = []
    loop = Solution._loop

    def counted(self: Solution, region: Region) -> Any:
        found.append(region)
        return loop(self, region)

    with monkeypatch.context() as patch:
        patch.setattr(Solution, "_loop", counted)
        patch.setattr("deburr.values.ledger._kept", Kept[Any]())
        assert values_of(analysis) is not None
    return len(found)


@pytest.mark.parametrize("dialect", CALLED)
def test_a_loop_is_gone_round_once_where_nothing_comes_that_it_reads(
    dialect: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = CALLED[dialect].format(read=1)
    analysis = analysed(text, dialect)
    assert rounds(analysis, monkeypatch) == 1
    line, reading = LOOPS[dialect]
    assert rounds(analysed(CALLED[dialect].format(read=3).replace(line, reading), dialect), monkeypatch) > 1
    row, counter, other = INSIDE[dialect]
    program = values_of(analysis)
    assert program is not None
    held = [program.value(analysis.file, row, key, False) for key in (counter, other)]
    assert [(value.low, value.high) for value in held if value is not None] == [(0.0, 8.0), (1.0, 2.0)]


@pytest.mark.parametrize("dialect", MAKERS)
def test_what_is_proven_is_what_going_round_again_proves(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    taken: list[Region] = []
    take_over = Solution._take_over

    def counted(self: Solution, region: Region, *more: Any) -> None:
        taken.append(region)
        take_over(self, region, *more)

    monkeypatch.setattr(Solution, "_take_over", counted)
    programs = [(made.text, made.files) for made in map(MAKERS[dialect], range(SEEDS))]
    for text, files in [(macros(dialect, 900), {}), *programs]:
        found = _proven(analysed(text, dialect, files), monkeypatch)
        with monkeypatch.context() as patch:
            patch.setattr(Region, "key", lambda self, env, forgotten: None)
            assert _proven(analysed(text, dialect, files), monkeypatch) == found, text
    assert len(taken) > SEEDS / 4


def _proven(analysis: Analysis, monkeypatch: pytest.MonkeyPatch) -> object:
    """All that is known of each routine, as it is called and whatever it is called with."""
    monkeypatch.setattr("deburr.values.ledger._kept", Kept[Any]())
    program = values_of(analysis)
    if program is None:
        return None
    for _ in program.general.solving() if program.general is not program else ():
        pass
    return [
        (name, _before(solved.solution), solved.returned, solved.called, solved.solution.doubtful)
        for each in (program, program.general)
        for name, solved in each.solved.items()
    ]


def _before(solution: Solution) -> dict[int, tuple[Env, tuple[int, ...], set[int], tuple[Key, ...]]]:
    said = {**solution.proofs, **solution.remarks}
    return {
        node: (env, solution.targets(node), set(solution.sources(node)), (said[node].args if node in said else ()))
        for node, env in solution.before.items()
    }
