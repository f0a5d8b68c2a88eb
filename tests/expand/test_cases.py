"""Every case of every dialect: the flat program, its map and what the run met are exactly those in the file."""

import pytest

from deburr_grammar.dialects import NAMES
from support.cases import Case, cases, expanded, mapped

CASES = [pytest.param(case, id=f"{name}-{case.name}") for name in NAMES for case in cases(name)]


@pytest.mark.parametrize("case", CASES)
def test_a_case_gives_what_it_says(case: Case) -> None:
    expansion = expanded(case)
    said = [f"{fault.kind} {fault.file}:{fault.line + 1} {fault.message}" for fault in expansion.faults]
    wanted = case.parts.get("faults", "").strip("\n").split("\n") if case.parts.get("faults") else []
    assert len(said) == len(wanted), said
    for found, expected in zip(said, wanted, strict=True):
        head, _, words = expected.partition(" ")
        place, _, words = words.partition(" ")
        assert found.startswith(f"{head} {place} ") and words in found, said
    assert expansion.lines == case.expected
    wanted = case.parts["map"].strip("\n").split("\n") if case.parts.get("map", "").strip("\n") else []
    if case.dialect != "rs274" or wanted:
        assert mapped(expansion) == wanted
