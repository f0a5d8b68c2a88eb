"""Operator that does not exist.

The operators are `**`, `*`, `/`, `MOD`, `+`, `-`, `EQ`, `NE`, `GT`, `GE`, `LT`, `LE`, `AND`, `OR`
and `XOR`. There is no `^`, no `<`, no `==`, and a comment may not stand inside an expression.
Where `]` is missing, the control takes what comes next for an operator. It stops with "Unknown
operation".

Source: spec/rs274.md §3.1

Bad:

    #1=[2^3]
         ^
    #1=[1 < 2]
          ^
    #1=[1 (x) + 2]
          ^^^
    G0 X[3*[2+1] Y2
                 ^
    #1=[5−2]
         ^

Good:

    #1=[2**3]
    #1=[1 LT 2]
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import advised
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.rules.rs274._characters import foreign
from deburr.suggest import suggestion
from deburr_grammar.problem import Problem
from deburr_grammar.tree import Token


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what stands in the operator's place."""
    said, pair = line.said(problem), line.text[problem.start : problem.start + 2]
    if message := foreign(said[0]):
        pass
    elif written := _MEANT.get(pair) or _MEANT.get(said):
        message = f"`{pair if pair in _MEANT else said}` is no operator; write `{written}`"
    elif opened := _left_open(line, problem):
        begun = line.text[opened.start : problem.start].rstrip()
        message = f"`]` is missing before `{said}`; `{_short(begun)}` is open here"
    elif said.startswith("("):
        message = f"`{said}` stands inside an expression, where no comment may; write it before or behind the brackets"
    else:
        message = f"`{said}` is no operator{suggestion(said.upper(), _NAMES) or expected(problem)}"
    yield Report(whole(problem), message)


def _left_open(line: Line, problem: Problem) -> Token | None:
    """The innermost open bracket, if nothing behind closes it, so that `]` must have been meant before what stands here."""
    behind = line.text[problem.start :]
    if behind.count("]") > behind.count("["):
        return None
    depth = 0
    for part in reversed(line.node.tree.children):
        if isinstance(part, Token) and part.kind in ("LSQB", "RSQB"):
            depth += 1 if part.kind == "LSQB" else -1
            if depth > 0:
                return part
    return None


def _short(text: str) -> str:
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."


_SHOWN = 30
_NAMES = ("MOD", "EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR")
_MEANT = {
    "^": "**",
    "<": "LT",
    "<=": "LE",
    ">": "GT",
    ">=": "GE",
    "=": "EQ",
    "==": "EQ",
    "!=": "NE",
    "<>": "NE",
    "%": "MOD",
    "&&": "AND",
    "||": "OR",
    "&": "AND",
    "|": "OR",
}


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the operator that is meant, the bracket that is missing, or leave the comment out."""
    message = broken.finding.message
    if "is missing before" in message:
        start = len(broken.text[: broken.span.start].rstrip())
        yield broken.inserted(start, "]")
    elif "inside an expression" in message:
        yield broken.deleted(*broken.span)
    else:
        yield from advised(broken)
