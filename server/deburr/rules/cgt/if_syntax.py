"""`#IF` or `#IFSTR` that is no test with a body.

A test compares: `#IF(#V1>3)`, with `= <> > >= < <=`; `#IFSTR` compares a word with a word or with
unquoted text, with `=` or `<>`. Tests are joined by `,#AND` and `,#OR`. The body's `<` follows the
parenthesis directly.

Source: spec/cgt.md §3, §5.4, §11

Bad:

    #IF(#V1)<M08>
    ^^^^^^^^
    #IF(#V1>3)
    ^^^^^^^^^^
    #IF(#V1>3) <M08>
    ^^^^^^^^^^
    #IF #V1=3<M08>
    ^^^
    #IF(#V1>3,#V2>3)<M08>
              ^^^
    #IF(#V1=M08)<M08>
            ^^^
    #IF(1<#V1<3)<M08>
             ^
    #IF(#V1=>3)<M08>
           ^^
    #IF(V1>3)<M08>
        ^^
    #IFSTR(#S1)<M08>
    ^^^^^^^^^^^
    #IFSTR(#S1>G00)<M08>
              ^
    #IFSTR(G00=#S1)<M08>
           ^^^
    #IFCHG(#XPOS)
    ^^^^^^^^^^^^^

Good:

    #IF(#V1>3)<M08>#ELSE<M09>
    #IF((#V1+1)*2<>-3,#AND #V2<=3)<M08>
    #IFSTR(#S1=G00 X5)<M08>
    #IFSTR(#S1<>#S2,#OR#S1=)<M08>
    #IFCHG(#SPEED)<M08>
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import advised, blanks_left_out
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.templates.symbols import missing_sign
from deburr_grammar.problem import Problem
from deburr_grammar.text import Span

_WRONG = {"=>": ">=", "=<": "<=", "==": "=", "!=": "<>", "><": "<>"}
_NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what does not fit."""
    said = line.said(problem)
    if (sign := _sign(line.text, problem)) is not None:
        wrong = line.text[sign.start : sign.end]
        yield Report(sign, f"`{wrong}` is no comparison; write `{_WRONG[wrong]}`")
    elif (name := _name(line.text, problem)) is not None:
        bare = line.text[name.start : name.end]
        if hint := missing_sign(bare):
            yield Report(name, f"`{bare}` is no number{hint}")
        else:
            yield Report(name, f"`{bare}` is text, and `#IF` compares numbers; compare texts with `#IFSTR`")
    else:
        what = "is no complete test" if said.upper().startswith("#IF") else "does not fit into the test"
        yield Report(whole(problem), f"`{said}` {what}{missing_sign(said) or expected(problem)}")


def _sign(text: str, problem: Problem) -> Span | None:
    """A comparison of another language, of which the fault is the first or the second sign."""
    for start in (problem.start, problem.start - 1):
        if text[max(0, start) : start + 2] in _WRONG:
            return Span(start, start + 2)
    return None


def _name(text: str, problem: Problem) -> Span | None:
    """A name without `#` in a test of numbers: the fault is what stands behind it, which is no parenthesis."""
    said = text[problem.start : problem.end]
    end = problem.end - 1 if said.upper().startswith("#IF(") and said.endswith(")") else problem.start
    if "`(`" not in problem.expected:
        return None
    found = [match for match in _NAME.finditer(text, 0, end) if match.end() == len(text[:end].rstrip(" \t"))]
    return Span(*found[-1].span()) if found and text[found[-1].start() - 1] != "#" else None


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave out the blanks before the body, or write what the message says."""
    if "`<` directly behind" in broken.finding.message:
        yield from blanks_left_out(broken, "<")
    else:
        yield from advised(broken)
