"""Character that means nothing in a program.

Outside comments a line holds letters, digits and `+ - * / . # = [ ] < > ( ) ; % @ ^ $`, each
where it has a meaning. The control stops with "Bad character used".

Source: spec/rs274.md §1

Bad:

    G0 X1 & Y2
          ^
    G0 X1 )
          ^
    G0 X1,5
         ^

Good:

    G0 X1.5 (& , are text here)
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the character."""
    yield Report(whole(problem), f"`{line.said(problem)}` has no meaning here; the control stops at a bad character")
