"""Count of repetitions that is no integer.

The control rounds it, half to even: 2.5 gives two turns, 3.5 four.

Source: spec/rs274.md §6

Bad:

    o1 repeat [2.5]
              ^^^^^
    o1 endrepeat

Good:

    o1 repeat [2]
    o1 endrepeat
    o2 repeat [5/2*2]
    o2 endrepeat
    #1=3
    o3 repeat [#1]
    o3 endrepeat
"""

import re
from collections.abc import Iterator

from deburr.arithmetic.rs274 import constant
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR, literal
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


def _count(node: Node) -> Node | None:
    return node.node("group") if node.find("REPEAT") else None


def _may(line: Line, node: Node) -> bool:
    count = _count(node)
    return count is not None and literal(count) and line.said(count).strip("[]0 \t") != ""


@rule(Severity.WARNING, Nodes(("o_line",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the count."""
    count = _count(node)
    value = constant(line.text, count, line.settings) if count else None
    if count and isinstance(value, float) and abs(value - round(value)) > NEAR:
        turns = max(0, round(value))
        message = f"`{line.said(count)}` is no integer; the control rounds it and repeats {turns} times"
        yield Report(Span(count.start, count.end), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the number of passes that the control makes."""
    passes = re.search(r"repeats ([0-9]+) time", broken.finding.message)
    if passes is not None:
        yield broken.replaced(f"[{passes[1]}]")
