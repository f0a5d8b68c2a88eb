"""`#IFCHG` of something that is no word.

It asks whether words have changed since they were last output, so it takes words and nothing
else.

Source: spec/cgt.md §5.4, §7

Bad:

    #IFCHG(3)<M08>
           ^
    #IFCHG()<M08>
    ^^^^^^^^
    #IFCHG(#XPOS=1)<M08>
                ^

Good:

    #IFCHG(#SPEED, #SPNDL)<M08>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, expected, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report what is no word."""
    yield Report(
        whole(problem), f"`{line.said(problem)}`: `#IFCHG` takes words with commas between them{expected(problem)}"
    )
