"""Command with malformed arguments.

The generator cannot tell what the command works on. The parenthesis follows the command
directly and is closed on the same line.

Source: spec/cgt.md §3, §11, *Errors*

Bad:

    #CALL()
    ^^^^^^^
    #CALL(@TOOLCHG)
          ^^^^^^^^
    #GOTO
    ^^^^^
    #TABLE(t)
    ^^^^^^^^^
    #TABLE(t,)
    ^^^^^^^^^^
    #RESET(3)
           ^
    #UPDATE(#XPOS #YPOS)
                  ^^^^^
    #FMT(#XPOS)
    ^^^^^^^^^^^
    #FMT(XPOS,D3.4)
         ^^^^
    #REPEAT()<M08>
    ^^^^^^^^^
    #SETBLK(x)
    ^^^^^^^^^^
    #RETNUM()
    ^^^^^^^^^
    #EVMD(#x)
    ^^^^^^^^^
    #EVAL(#V1=1
    ^^^^^^^^^^^
    #IF(#V1>3
    ^^^^^^^^^
    #EVAL(#V1=SQR(4) // root
    ^^^^^^^^^^^^^^^^

Bad:

    @DECLARE
    #INT a
         ^
    #DEC #b,
    ^^^^^^^^
    #STR
    ^^^^
    @
    @DWELL
    #b

Good:

    #CALL(TOOLCHG)
    #RESET(#XPOS, #YPOS)
    #FMT(#XPOS, D+3.4, 10)
    #SETBLK(0)#GETBLK(0)
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import closed, did_you_mean
from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.templates.symbols import commands, missing_sign
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what does not fit."""
    said = line.said(problem)
    command = re.match("#([A-Za-z]+)", said)
    what = "is no complete command" if command and command[1].upper() in commands() else "does not fit into the command"
    bare = "a section's name" in problem.expected and re.fullmatch("[#@]([A-Za-z][A-Za-z0-9_]*)", said)
    hint = f"; write the name alone, `{bare[1]}`" if bare else missing_sign(said) or _needed(problem)
    yield Report(whole(problem), f"`{said}` {what}{hint}")


def _needed(problem: Problem) -> str:
    # A name without `#` is read as a function, whose parenthesis is then all that can follow.
    bare = problem.expected == ("`(`",)
    return "; a word begins with `#`, and a function has `(` behind its name" if bare else expected(problem)


def fix(broken: Broken) -> Iterator[Fix]:
    """Add the sign that is missing, or write the bare name."""
    message, start = broken.finding.message, broken.span.start
    if "write the name alone" in message:
        yield broken.replaced(broken.quoted[-1])
    elif "expected `,` or" in message and broken.said.startswith("#"):
        yield Fix("Insert `,`", (broken.edit(len(broken.text[:start].rstrip()), start, ","),))
    elif "expected `)`" in message or "`,`, `)` or" in message:
        yield from closed(")")(broken)
    else:
        yield from did_you_mean(broken)
