"""How lines run, as far as their shapes decide it: decided once a shape. Looks at no line."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.expand.rs274.words import COMMENT, codes_of, starts
from deburr_grammar.dialects.rs274.commands import COMMANDS
from deburr_grammar.dialects.rs274.outline import PROGRAM, aborts, computes_code
from deburr_grammar.tree import Node, Token, tokens, walk

if TYPE_CHECKING:
    from deburr_grammar.dialect import Reading
    from deburr_grammar.line import Shape

RUNS = frozenset(("param", "setting", "group", "function", "atan", "exists", "CALL", "active"))
"""What only a run can tell."""
_LEAVES = frozenset(("M70", "M71", "M72", "M73", "M98"))
"""Codes behind which only a run tells what is in force, or whether `M72` may follow."""
NOT_PLAIN = RUNS | {"o_line", "PERCENT", "DELETE", "NUMBER_USED", "NAME_USED"}
CONTOURED = frozenset(("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"))
"""Lathe cycles that read a subprogram as the contour of the part."""
FLOW = frozenset(("M2", "M30", "M70", "M71", "M72", "M73", "M98", "M99")) | CONTOURED
"""Codes that end the program, go elsewhere, or need more than their own line."""
_OTHERS = frozenset(("o_line", "PERCENT", "DELETE", "active", "CALL"))
"""What is compiled line by line."""
_COMMANDS = frozenset(map(str.upper, COMMANDS))
_COMMENTS = ("COMMENT", "SEMICOLON_COMMENT")
_LEAVING = re.compile(r"[mM][ \t0+]*[79]")
"""Where one of the codes that leave can stand: most shapes need no second look."""


def needs_run(shape: Shape, reading: Reading) -> bool:
    """Whether what is wrong with lines of a shape, or with what hangs on them, may be seen by a run alone."""
    facts = shape.facts(reading)
    if not RUNS.isdisjoint(facts.kinds):
        return True
    if "o_line" in facts.kinds and _COMMANDS.isdisjoint(facts.kinds):
        # Whether the run comes by it in a subprogram hangs on where the program ends.
        return True
    return not facts.problems and _LEAVING.search(shape.text) is not None and not _LEAVES.isdisjoint(codes_of(shape))


def is_plain(shape: Shape, reading: Reading) -> bool:
    """Whether lines of a shape can be copied: nothing in them is to be calculated, and the next line is the next."""
    key = ("rs274 plain", reading.name)
    found = shape.memo.get(key)
    if found is None:
        facts = shape.facts(reading)
        readable = reading.start is not None and not facts.problems and facts.kinds.isdisjoint(NOT_PLAIN)
        found = readable and FLOW.isdisjoint(codes_of(shape)) and not aborts(shape.text)
        shape.memo[key] = found
    return bool(found)


def fixed(shape: Shape) -> tuple[int, ...] | None:
    """Which numbers of a line decide what it is compiled to; None of lines that are compiled one by one."""
    if "rs274 fixed" not in shape.memo:
        shape.memo["rs274 fixed"] = _fixed(shape)
    found = shape.memo["rs274 fixed"]
    assert found is None or isinstance(found, tuple)
    return found


def _fixed(shape: Shape) -> tuple[int, ...] | None:
    facts = shape.facts(PROGRAM)
    if facts.problems or not facts.kinds.isdisjoint(_OTHERS) or not FLOW.isdisjoint(codes_of(shape)):
        return None
    if computes_code(shape.text, shape.tree(PROGRAM)):
        return None
    comment = COMMENT.search(shape.text)
    end = len(shape.text) if comment is None else comment.start()
    if aborts(shape.text) or any(
        part.start >= end for part in tokens(shape.tree(PROGRAM)) if part.kind not in _COMMENTS
    ):
        return None
    places, found = starts(shape.text), set[int]()
    for part in walk(shape.tree(PROGRAM)):
        if isinstance(part, Node) and part.kind == "param" and isinstance(said := part.children[1], Token):
            found |= {at for start, at in places.items() if said.start <= start < said.end}
    return tuple(sorted(found))
