"""What a Z32 run starts with: `$FCEPP` lines, the setting `pal`, and values that were defined for it (spec/z32.md §5, §6.6). Runs no block."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from deburr.expand.z32.blocks import optional, undecided
from deburr.expand.z32.state import LAST
from deburr_grammar.dialects.z32.forms import number
from deburr_grammar.dialects.z32.outline import PROGRAM
from deburr_grammar.line import LineNode

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.expand.z32.state import State

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)")
_NAME = re.compile(r"[A-Z][A-Z]?")
_VECTOR = re.compile(r"PA([LR])[ \t]*\[[ \t]*([0-9]{1,9})[ \t]*\]")
_NO_NAMES = frozenset(("N", "G", "O", "SN", "CS", "AT", "RQ", "PI", "CP", "PC", "IF", "EB", "AA", "AB", "AC"))
"""Names that are no parameters (spec/z32.md §2, §6.5)."""


def first_values(state: State) -> None:
    """The machine's values, what the program declares, and over them what was defined for this run: `HA=10`, `PAL[300]=5`."""
    for index, value in state.job.settings["pal"].items():
        state.pal[int(index)] = float(value)
    for row, node in _configuring(state):
        if optional(state, node) is None:
            raise undecided(state, state.main, row, node.text)
        if optional(state, node) is False:
            _configure(state, node)
    for name, said in state.job.inputs.define.items():
        _define(state, name.strip().upper(), said.strip(), f"{name}={said}")


def _configuring(state: State) -> Iterator[tuple[int, LineNode]]:
    """The `$FCEPP` lines before the first block; an emulator reads them in the title too."""
    document = state.main.document
    if "$" not in document.text:
        return
    for row in range(min(state.main.first_block, document.line_count)):
        node = document.node(row)
        if "$" not in node.text:
            continue
        read = node if node.reading.start is not None else LineNode(node.text, PROGRAM, node.shape)
        if "config" in read.kinds and not read.problems:
            yield row, read


def _configure(state: State, node: LineNode) -> None:
    config = next(node.find("config"))
    said = [node.text[part.start : part.end] for part in config.children if part.kind in ("STRING", "PLAIN")]
    what, *arguments = [each.strip("'") for each in said] or [""]
    if what.upper() == "SET_FILEROOT" and arguments:
        state.root = arguments[0]
    elif what.upper() == "ADD_VAR_SYST_SPEC" and arguments:
        name = arguments[0].upper()
        state.system.add(name)
        if len(arguments) > 1 and _NUMBER.fullmatch(arguments[1]):
            state.params[name] = number(arguments[1])


def _define(state: State, name: str, value: str, said: str) -> None:
    if not _NUMBER.fullmatch(value) or not math.isfinite(number(value)):
        raise state.job.unusable("number-format", said, f"`{value}` is no number")
    vector = _VECTOR.fullmatch(name)
    if vector is None:
        if not _NAME.fullmatch(name) or name in _NO_NAMES:
            raise state.job.unusable("parameter-reserved", said, f"`{name}` is no parameter")
        state.params[name] = number(value)
        return
    at, given = int(vector[2]), number(value)
    if at > LAST:
        raise state.job.unusable("index-range", said, f"the index goes from 0 to {LAST}")
    if vector[1] == "R":
        state.par[at] = given
    elif given.is_integer():
        state.pal[at] = given
    else:
        raise state.job.unusable("number-format", said, "PAL holds integers")
