"""O-word command that does not exist.

The commands are sub, endsub, return, call, if, elseif, else, endif, while, endwhile, do, repeat,
endrepeat, break and continue. The control stops with "Unknown control command in o word".

Source: spec/rs274.md §6

Bad:

    o1 foo
       ^^^
    o1 endfor
       ^^^^^^

Good:

    o1 do
    o1 while [0]
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr.suggest import suggestion
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the command."""
    yield Report(whole(problem), f"`{line.said(problem)}` is no O-word command{_meant(line.said(problem))}")


_COMMANDS = [
    "sub",
    "endsub",
    "return",
    "call",
    "if",
    "elseif",
    "else",
    "endif",
    "while",
    "endwhile",
    "do",
    "repeat",
    "endrepeat",
    "break",
    "continue",
]


def _meant(name: str) -> str:
    return suggestion("".join(name.split()).lower(), _COMMANDS)
