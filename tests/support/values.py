"""Runs of programs beside their proven values: what is seen at each line must lie in what was proven for it."""

from __future__ import annotations

from collections import Counter
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr.values import values_of
from deburr.values.domain import Value, joined
from deburr.values.graph import Key
from deburr.values.program import Program
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

MAIN = "main.ngc"


class Known(NamedTuple):
    """What is proven of the lines of a program: the values before each line that takes part, and the lines that cannot be passed."""

    before: dict[int, dict[Key, Value]]
    taking: frozenset[int]
    stopping: frozenset[int]


def analysed(
    text: str, dialect: str, files: dict[str, str] | None = None, inputs: Inputs | None = None, path: str = MAIN
) -> Analysis:
    """A program as it is checked."""
    language = by_name(dialect)
    return Analysis(Document.parse(text, language), RuleSet(language), path, MemoryHost(files or {}), inputs=inputs)


def known(analysis: Analysis, file: str = MAIN) -> Known | None:
    """What is proven of the lines of a file; None where nothing is said of the program."""
    program = values_of(analysis)
    return None if program is None else _of(program, file)


def known_generally(analysis: Analysis, file: str = MAIN) -> Known | None:
    """What is proven whatever routines are called with and constants are; None where nothing is said of the program."""
    program = values_of(analysis)
    if program is None:
        return None
    if program.general is not program:
        for _ in program.general.solving():
            pass
    return _of(program.general, file)


def _of(program: Program, file: str) -> Known:
    before: dict[int, dict[Key, Value]] = {}
    taking: set[int] = set()
    stopping: set[int] = set()
    for name, routine in program.routines.items():
        if file != MAIN and routine.files is None or routine.is_elsewhere(file):
            continue
        taking |= set(routine.rows)
        solved = program.solved.get(name)
        if solved is None:
            continue
        rows = Counter(routine.rows[node.line] for node in routine.graph.nodes.values())
        for node, env in solved.solution.before.items():
            row = routine.rows[routine.graph.nodes[node].line]
            old = before.get(row)
            before[row] = env if old is None else {key: joined(old[key], env[key]) for key in old.keys() & env.keys()}
            if node in solved.solution.proofs and rows[row] == 1:
                stopping.add(row)
    return Known(before, frozenset(taking), frozenset(stopping))
