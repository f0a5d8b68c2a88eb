"""Line of more than 20,000 characters.

No control takes such a line and nobody wrote it: the file is something else, or its line ends
are lost. Nothing else is said of the line.

Source: deburr's own limit

Bad:

    {x*20001}
    ^^^^^^^^^

Good:

    {(}deburr speaks here{)}
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Syntax, rule, whole
from deburr_grammar.problem import Problem


@rule(Severity.ERROR, Syntax())
def check(line: Line, problem: Problem) -> Iterator[Report]:
    """Report the line."""
    message = f"a line of {len(line.text)} characters; no control takes it, are the line ends lost?"
    yield Report(whole(problem), message)
