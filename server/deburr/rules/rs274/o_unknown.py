"""O-word command that does not exist.

The commands are sub, endsub, return, call, if, elseif, else, endif, while, endwhile, do, repeat,
endrepeat, break and continue. The control stops with "Unknown control command in o word", or with
"Unexpected character after O-word" where more letters follow a command. A word that was likely
meant as one of them opens or closes its block all the same, so that nothing else is said of it. An end
is asked to be that of the block that is open.

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

    o1 if [1]
    o1 next
       ^^^^

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
from typing import TYPE_CHECKING

from deburr.blocks import DEEPEST
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.rs274._o_words import ENDS, misspelt
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.rs274.commands import COMMANDS, meant

if TYPE_CHECKING:
    from deburr.analysis import Analysis

_REGIONS = (Role.REGION, Role.END_REGION)
_CLOSES = (Role.CLOSE, Role.END_REGION)
_NOTHING = ("end", "next", "endloop")
"""What tells nothing of the block that it is to end."""


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report the command."""
    found = [(line, problem) for line, problem in analysis.document.problems() if problem.kind == "o-unknown"]
    ends = dict(_ends(analysis)) if found else {}
    for line, problem in found:
        word = analysis.document.line(line)[problem.start : problem.end]
        command = ends.get(line) or meant(word)
        if line not in ends and word.lower() in _NOTHING:
            hint = "write what ends: `endif`, `endwhile`, `endrepeat` or `endsub`"
        else:
            hint = f"did you mean `{command}`?" if command else f"the commands are {', '.join(COMMANDS)}"
        yield Report(whole(problem), f"`{word}` is no O-word command; {hint}", line)


def _ends(analysis: "Analysis") -> Iterator[tuple[int, str]]:
    """The lines of misspelt ends, each with the command that ends the block that is open there."""
    opened: list[Bracket] = []
    for line, bracket in analysis.document.brackets():
        if bracket.role in _CLOSES and opened and misspelt(bracket):
            yield line, ENDS[_meant(bracket, opened).kind]
        if bracket.role is Role.OPEN:
            opened.append(bracket)
        elif bracket.role is Role.CLOSE and opened and opened[-1].role is Role.OPEN:
            opened.pop()
        elif bracket.role in _REGIONS:
            opened = [bracket] if bracket.role is Role.REGION else []


def _meant(end: Bracket, opened: list[Bracket]) -> Bracket:
    """The block of the same label, or the innermost."""
    return next((block for block in reversed(opened[-DEEPEST:]) if block.label == end.label), opened[-1])


fix = did_you_mean
