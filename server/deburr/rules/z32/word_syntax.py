"""Text that is no word, comment or `;`.

A block is made of addresses with a value: `X10`, `X<HA+1>`. Assignments, IF and jumps stand
between `!` and `!`. The control refuses a line with anything else in it.

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
    :1.5
    ^^^^

Good:

    G0 X5
    !X=5!
    X<-HA>
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.rules.z32._words import INSTRUCTIONS, instruction_for
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the text."""
    yield Report(whole(problem), _fault(line, problem) + _hint(line, problem))


def _fault(line: Line, problem: Problem) -> str:
    said, behind = line.said(problem), line.text[problem.end :].lstrip()
    if behind.startswith("="):
        stored = behind[1:].partition(";")[0].partition("(")[0].strip()
        return f"`{said}=` stores a value, which stands between `!` and `!`: `!{said}={stored}!`"
    if said.startswith(":"):
        return _section(line, said)
    if said.startswith("$") or "$" in said:
        return f"`{said}` sets up nothing; a line of that sort is `NAME=$FCEPP('...')`"
    if said.upper().startswith(("FCEPP", "FECPP")):
        return f"`{said}` is no word; did you mean `$FCEPP`?"
    if said in ("+", "-"):
        return f"`{said}` stands before a number only; inside the brackets, `<-...>`, it changes the sign"
    if said.upper() in ("PAL", "PAR"):
        return f"`{said}` takes its index in square brackets, as in `{said.upper()}[1]`"
    if said.upper() == "O" and line.text[: problem.start][-1:].isdigit():
        return f"`{said}` is a letter and no part of the number before it; the digit is written `0`"
    return f"`{said}` {_why(said)}"


def _why(said: str) -> str:
    if instead := instruction_for(said):
        return f"is no word that the control can read; {instead}, between `!` and `!`"
    if said.upper() in INSTRUCTIONS:
        return "is no word that the control can read; instructions stand between `!` and `!`"
    if said.isalpha():
        return "has no value, so the control cannot read it as a word"
    return "is no word that the control can read"


def _section(line: Line, said: str) -> str:
    if said.upper().replace(" ", "").startswith(":L254"):
        return f"`{said}` calls a file, which stands between `!` and `!`"
    if said[1:2].isdigit() and not line.text.lstrip(" \t/").startswith(":"):
        return f"`{said}` starts a section, which stands alone at the start of a line"
    return f"`{said}` starts no section: its number is an integer, as in `:1`"


def _hint(line: Line, problem: Problem) -> str:
    said = line.said(problem)
    told = line.text[problem.end :].lstrip().startswith("=") or said[:1] in ("+", "-", ":", "$") or "$" in said
    told = told or said.upper().startswith(("FCEPP", "FECPP")) or said.upper() in ("O", "PAL", "PAR", *INSTRUCTIONS)
    return "" if told or instruction_for(said) else expected(problem)


def fix(broken: Broken) -> Iterator[Fix]:
    """Store the value in an advanced line."""
    if "stores a value" in broken.finding.message:
        whole = broken.quoted[-1].strip("!")
        if broken.text.startswith(whole, broken.span.start):
            end = broken.span.start + len(whole)
            yield Fix(f"Write `!{whole}!`", (broken.edit(broken.span.start, end, f"!{whole}!"),))
