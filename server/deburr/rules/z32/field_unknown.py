"""Instruction that an advanced line does not know.

Between `!` and `!` there are assignments, IF, EB, CP, PC, GON, GOP, GOS and `:L254-`; the control
refuses the line if it finds anything else.

Source: spec/z32.md §3

Bad:

    !FOO!
     ^^^
    !HA=1; GOTO10!
           ^^^^^^
    !GON1-200!
     ^^^^^^^^
    !GON!
     ^^^
    !HAA=5!
     ^^^^^

Good:

    !HA=1; GON10!
    G0 X1
    N10 G0 X2
"""

import re
from collections.abc import Iterator
from difflib import get_close_matches

from deburr.fixers import advised
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.rules.z32._words import INSTRUCTIONS, instruction_for
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the field."""
    said = line.said(problem)
    yield Report(whole(problem), f"`{said}` is no instruction of an advanced line{_hint(said, problem)}")


def _hint(said: str, problem: Problem) -> str:
    for pattern, way_out in _SLIPS:
        if match := pattern.fullmatch(said):
            return f"; {match.expand(way_out)}"
    letters = re.match("[A-Za-z]*", said)
    name = letters[0].upper() if letters else ""
    if name in INSTRUCTIONS:
        return expected(problem)
    if instead := instruction_for(name):
        return f"; {instead}"
    near = get_close_matches(name, INSTRUCTIONS, 1, 0.6)
    return (
        f"; did you mean `{near[0]}`?" if near else f"; there are `name=value`, {', '.join(INSTRUCTIONS)} and `:L254-`"
    )


_SLIPS = tuple(
    (re.compile(pattern, re.ASCII | re.I), way_out)
    for pattern, way_out in (
        (r"GON[ \t]*([0-9.,]+)[ \t]*-[ \t]*[A-Z]*[ \t]*([0-9.,]+)", r"a range is written `GON\1-N\2`"),
        (r"GON[ \t]*([0-9.,]+)[ \t]+([0-9.,]+)", r"a range is written `GON\1-N\2`"),
        (r"(GO[NPS])[ \t]*(?:N|[ \t][A-Z]+)[ \t]*([0-9.,]+)", r"only the number stands behind it, `\1\2`"),
        (r"(GO[NPS])[ \t]*([A-Z]{1,2})", r"a calculated number stands in brackets, `\1<\2>`"),
        (r":?[ \t]*L[ \t]*254[ \t]*[-:]?[ \t]*(.*)", r"a file is called by `:L254-\1`"),
        (r"([A-Z]{1,2}):=(.*)", r"a value is stored by `=`, `\1=\2`"),
        (r"PAL?[LA]L?[ \t]*(\[.*)", r"did you mean `PAL\1`?"),
        (r"PAR?[AR]R?[ \t]*(\[.*)", r"did you mean `PAR\1`?"),
        (r"(PA[LR])[ \t]*\(([^()]*)\)(.*)", r"the index stands in square brackets, `\1[\2]\3`"),
        (r"(PA[LR])[ \t]*([0-9]+)(.*)", r"the index stands in square brackets, `\1[\2]\3`"),
        (r"N[ \t]*[0-9.,]+.*", "a block number stands before the first `!`"),
        (r"([A-Z]{1,2}[ \t]*(?:[<>=]=|<>|[<>])[^=]*)", r"a comparison stands behind IF, `IF \1`"),
        (r"H[A-Z]{2,}[ \t]*=.*|H[0-9]+[ \t]*=.*|#.*", "user parameters are HA to HZ"),
    )
)
"""What is written in place of an instruction, and what is meant."""


fix = advised
