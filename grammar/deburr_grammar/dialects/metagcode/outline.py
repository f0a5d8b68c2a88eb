"""Which lines of a MetaGCODE text open and close blocks, and which name a snippet (spec/metagcode.md §2, §4)."""

import re
from collections.abc import Callable, Hashable

from deburr_grammar.dialect import Bracket, Reading, Role, Step
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Token, tokens

PROGRAM = Reading("program", "line")
READINGS = (PROGRAM,)
SNIPPET = "file"
"""The kind of the bracket on a `#FILE` line, which neither opens nor closes; its label is the name as it is written."""
UNKNOWN = "unknown"
"""The kind of the bracket on the line of a directive that does not exist; it does nothing, but may be one that is misspelt."""

_DIRECTIVES = {
    "IF": (Role.OPEN, "if"),
    "ENDIF": (Role.CLOSE, "if"),
    "LOOP": (Role.OPEN, "loop"),
    "ENDLOOP": (Role.CLOSE, "loop"),
    "FILE": (Role.MIDDLE, SNIPPET),
}
_DIGITS = re.compile(r"[0-9]+")


class MetaGCodeOutline:
    """Every line is read alike; directives alone have brackets."""

    marks = r"(?ai)^[ \t]*#[a-z]"
    needs_depth = ""

    def facts(self, text: str) -> frozenset[str]:
        """Nothing of the whole is needed."""
        return frozenset()

    def start(self, facts: frozenset[str]) -> Hashable:
        """There is no state."""
        return None

    def reading(self, state: Hashable) -> Reading:
        """A line is read wherever it stands."""
        return PROGRAM

    def step(self, state: Hashable, depth: int, facts: frozenset[str], read: Callable[[Reading], LineNode]) -> Step:
        """What a directive does. A faulty one opens or closes its block all the same (§10)."""
        bracket = _bracket(read(PROGRAM))
        return Step(PROGRAM, () if bracket is None else (bracket,), None)


def _bracket(line: LineNode) -> Bracket | None:
    said = list(tokens(line.tree))
    if not said or said[0].kind not in _DIRECTIVES:
        return _unknown(line, said[0]) if said and said[0].kind == "UNKNOWN" else None
    keyword, tail = said[0], _label(said)
    role, kind = _DIRECTIVES[keyword.kind]
    label = line.text[tail.start : tail.end] if tail else None
    return Bracket(role, kind, f"#{keyword.kind}", label, Span(keyword.start, tail.end if tail else keyword.end))


def _unknown(line: LineNode, keyword: Token) -> Bracket:
    digits = _DIGITS.match(line.text, keyword.end)
    word = line.text[keyword.start : keyword.end].upper()
    span = Span(keyword.start, digits.end() if digits else keyword.end)
    return Bracket(Role.MIDDLE, UNKNOWN, word, digits[0] if digits else None, span)


def _label(said: list[Token]) -> Token | None:
    return said[1] if len(said) > 1 and said[1].kind in ("LABEL", "NAME") else None
