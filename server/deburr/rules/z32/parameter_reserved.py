"""Name that is no parameter.

N, G and O are addresses of their own, and the names of functions and instructions mean nothing
else; none of them holds a value.

Source: spec/z32.md §2, §5, §11

Bad:

    !PI=3!
     ^^
    !N=3!
     ^
    !CP=3!
     ^^
    G0 N5 X1
       ^
    X<CP+1>
      ^^
    GON20
    ^^^

Good:

    N5 G0 X1
    !HA=PI; HX=1; HY=1; CP!
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule, whole
from deburr.rules.z32._words import INSTRUCTIONS
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("reserved",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    if any(problem.start == node.start for problem in line.node.problems):
        return
    name = line.said(node).upper()
    if name == "N":
        why = "a block number stands at the start of the line"
    elif name == "O" and line.text[: node.start][-1:].isdigit():
        why = "it is a letter, the digit is written `0`"
    elif name in INSTRUCTIONS:
        why = "it is an instruction and stands alone between `!` and `!`"
    else:
        why = "user parameters are HA to HZ"
    yield Report(whole(node), f"`{line.said(node)}` cannot hold a value; {why}")
