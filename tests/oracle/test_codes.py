"""The table of RS274's codes against the interpreter: what the table lacks is unknown there, and nothing else is."""

import re
from pathlib import Path

import pytest

from deburr_grammar.dialects import by_name
from support.oracle import complaints


@pytest.mark.oracle
@pytest.mark.parametrize(("letter", "step", "last"), [("G", 1, 999), ("M", 10, 990)])
def test_the_interpreter_knows_the_same_codes(letter: str, step: int, last: int, tmp_path: Path) -> None:
    tenths = range(0, last + 1, step)
    names = [f"{letter}{tenth // 10}" + (f".{tenth % 10}" if tenth % 10 else "") for tenth in tenths]
    said = complaints("".join(f"{name}\n" for name in names if name not in ("M2", "M30", "M99")) + "M2\n", tmp_path)
    unknown = {said[at + 1].strip() for at, line in enumerate(said[:-1]) if re.match("Unknown [gm] code used", line)}
    table = {entry.name for entry in by_name("rs274").codes.table("code")}
    assert {name for name in names if name not in unknown} == {name for name in names if name in table}
