"""Number that is not written as one, or stands without an address.

A number has digits, at most one decimal sign (`.` or `,`) and no blank inside, none behind its
sign either. What is to be calculated stands in `<...>`.

Source: spec/z32.md §2, §11

Bad:

    X.
     ^
    X1.2.3
     ^^^^^
    X1 2
     ^^^
    X- 5
     ^^^
    X1+5
      ^^
    5 X1
    ^
    HA<1..5*2>
       ^^^^

Good:

    X.1 Y 1. Z-0,5
    HA<1.5 - 2>
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("bad_number", "stray", "loose")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number, with its sign where that is the fault."""
    if any(problem.start <= node.start and node.end <= problem.end for problem in line.node.problems):
        return
    start = node.start if node.kind != "loose" else len(line.text[: node.start].rstrip(" \t")) - 1
    said = line.text[start : node.end]
    match node.kind:
        case "stray":
            why = "has no address; a calculated value is written `<...>` behind one"
        case "loose":
            why = "has a blank behind its sign; write them together"
        case _:
            why = "is no number: digits with one `.` or `,` and no blank inside"
    yield Report(Span(start, node.end), f"`{said}` {why}")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write sign and digits together."""
    if "write them together" in broken.finding.message:
        yield broken.replaced("".join(broken.said.split()))
