"""G25 that does not name three different axes.

G25XYZ lets AA, AB and AC stand for X, Y and Z; it takes three different letters without blanks.

Source: spec/z32.md §6.5

Bad:

    G25XX
    ^^^^^
    G25XXY
    ^^^^^^
    G25
    ^^^
    G25XYZA
    ^^^^^^^

Good:

    G25XYZ
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._alias import letters
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("axis_alias",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the word."""
    named = letters(line, node)
    if len(named) != 3 or len(set(named)) != 3:
        yield Report(
            whole(node),
            f"`{line.said(node)}` does not name three different axes, as in `G25XYZ`; AA, AB and AC stay unset",
        )
