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

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr.rules.cgt._symbols import commands
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what does not fit."""
    said = line.said(problem)
    command = re.match("#([A-Za-z]+)", said)
    what = "is no complete command" if command and command[1].upper() in commands() else "does not fit into the command"
    yield Report(whole(problem), f"`{said}` {what}{expected(problem)}")
