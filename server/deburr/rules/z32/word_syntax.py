"""Text that is no word, comment or `;`.

A block is made of addresses with a value: `X10`, `X<HA+1>`. Assignments, IF and jumps stand
between `!` and `!`.

Source: spec/z32.md §11

Bad:

    G0 X
       ^
    X=5
    ^
    X-<HA>
     ^
    G0 #5 X1
       ^
    IF HA>10
    ^^

Good:

    G0 X5
    !X=5!
    X<-HA>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the text."""
    said = line.said(problem)
    yield Report(whole(problem), f"{_fault(said, line.text[problem.end :].lstrip())}{_hint(said, problem)}")


def _fault(said: str, behind: str) -> str:
    if behind.startswith("="):
        return f"`{said}=` stores a value, which stands between `!` and `!`"
    if said in ("+", "-"):
        return f"`{said}` stands before a number only; inside the brackets, `<-...>`, it changes the sign"
    if said.isalpha() and said.upper() not in _INSTRUCTIONS:
        return f"`{said}` has no value, so the control cannot read it as a word"
    return f"`{said}` is no word that the control can read"


def _hint(said: str, problem: Problem) -> str:
    if said.upper() in _INSTRUCTIONS:
        return "; instructions stand between `!` and `!`"
    return expected(problem) if said not in ("+", "-") else ""


_INSTRUCTIONS = ("IF", "EB", "CP", "PC", "GON", "GOP", "GOS")
