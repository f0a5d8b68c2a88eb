"""RS274 and Z32: what comes of a line hangs on nothing but what it is said to read, so that it may be kept for that."""

from __future__ import annotations

from typing import Any

import pytest

from deburr.values import values_of
from deburr.values.graph import Calls, Env, Node, Proof, Summary
from deburr.values.remembered import Remembered
from support.programs import generated as rs274_program
from support.values import analysed
from support.z32programs import generated as z32_program

SEEDS = 30


class Nobody:
    """Who answers calls where nothing is called."""

    def call(self, label: str, arguments: Env, shared: Env) -> Summary | None:
        return None

    def again(self) -> None: ...


def outcome(node: Node, env: Env, calls: Calls) -> object:
    """Where a node goes on, with what it reads and sets, or why it cannot; and whether it may fail."""
    keys = sorted(node.used | node.sets - {None}, key=str)
    try:
        found: object = [(to, [values.get(key) for key in keys]) for to, values in node.flow(env, calls)]
    except Proof as proof:
        found = proof.kind, proof.span
    return found, node.doubtful()


def found_anew(line: Remembered[Any], env: Env) -> Any:
    """What comes of a line of which nothing is kept."""
    line._expressions.doubtful = False
    return line._find(env)


MAKERS = {"rs274": rs274_program, "z32": z32_program}


@pytest.mark.parametrize("dialect", MAKERS)
def test_a_line_hangs_on_what_it_reads_alone(dialect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Remembered, "of", found_anew)
    compared = 0
    for seed in range(SEEDS):
        made = MAKERS[dialect](seed)
        program = values_of(analysed(made.text, dialect, made.files))
        for solved in program.solved.values() if program is not None else ():
            graph = solved.solution.graph
            for at, env in solved.solution.before.items():
                node = graph.nodes[at]
                if node.calls or None in node.used or not node.used:
                    continue
                narrow = {key: value for key, value in env.items() if key in node.used | node.sets | graph.hidden}
                assert outcome(node, env, Nobody()) == outcome(node, narrow, Nobody()), (seed, at)
                compared += 1
    assert compared > 3 * SEEDS
