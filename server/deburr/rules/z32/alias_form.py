"""G25 that does not name three different axes.

G25XYZ lets AA, AB and AC stand for X, Y and Z. It takes three different letters without blanks;
with anything else AA, AB and AC name no axis and the control stops at their first use.

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
    G25 XYZ
    ^^^^^^^

Good:

    G25XYZ
"""

from collections.abc import Iterator

from deburr.fixers import advised
from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._alias import axes, letters
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("axis_alias",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the word."""
    if not axes(line, node):
        message = f"`{line.said(node)}` does not name three different axes, so AA, AB and AC stay unset"
        yield Report(whole(node), f"{message}; {_way_out(letters(line, node))}")


def _way_out(said: str) -> str:
    joined = "".join(said.split())
    if joined != said and len(set(joined)) == len(joined) == 3:
        return f"write `G25{joined}` without blanks"
    return "write three letters without blanks, as in `G25XYZ`"


fix = advised
