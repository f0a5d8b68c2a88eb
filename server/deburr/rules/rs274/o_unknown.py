"""O-word command that does not exist.

The commands are sub, endsub, return, call, if, elseif, else, endif, while, endwhile, do, repeat,
endrepeat, break and continue. The control stops with "Unknown control command in o word", or with
"Unexpected character after O-word" where more letters follow a command. A word that was likely
meant as one of them opens or closes its block all the same, so that nothing else is said of it.

Source: spec/rs274.md §6

Bad:

    o1 foo
       ^^^
    o2 gosub [5]
       ^^^^^

Bad:

    o1 loop [3]
       ^^^^
    o1 endfor
       ^^^^^^

Bad:

    #1=0
    o1 while [#1 LT 3]
      #1=[#1+1]
    o1 wend
       ^^^^
    o2 callsub [5] [6]
       ^^^^^^^

Good:

    o1 do
    o1 while [0]
"""

from collections.abc import Iterator

from deburr.fixers import did_you_mean
from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.dialects.rs274.commands import COMMANDS, meant
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the command."""
    word = line.said(problem)
    command = meant(word)
    if word.lower() in _ENDS:
        hint = "write what ends: `endif`, `endwhile`, `endrepeat` or `endsub`"
    else:
        hint = f"did you mean `{command}`?" if command else f"the commands are {', '.join(COMMANDS)}"
    yield Report(whole(problem), f"`{word}` is no O-word command; {hint}")


_ENDS = ("end", "next", "endloop")
"""What tells nothing of the block that it is to end."""


fix = did_you_mean
