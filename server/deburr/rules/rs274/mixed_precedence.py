"""Expression that manuals and habits read differently.

AND, OR and XOR are of one level and go from left to right: `[1 OR 0 AND 0]` is 0. By the older
manual they share theirs with `+` and `-`. A sign binds closer than `**`, so `[-2**2]` is 4, and
`[2**3**2]` is 64. Brackets make sure.

Source: spec/rs274.md §3.1

Bad:

    #1=[0 AND 1 + 1]
              ^^^^^
    #1=[1 OR 0 AND 0]
        ^^^^^^
    #1=[-2**2]
        ^^
    #1=[2**3**2]
        ^^^^

Good:

    #1=[0 AND [1 + 1]]
    #1=[1 OR [0 AND 0]]
    #1=[-[2**2]]
    #1=[2**[3**2]]
    #1=[5-2**2]
    #1=[-2**3]
    #2=1
    #1=[#2 GT 1 AND #2+1 LT 5 AND #1]
    #1=[#2 AND #1 OR #2]
"""

from collections.abc import Iterator

from deburr.arithmetic import ArithmeticFault
from deburr.arithmetic.rs274 import constant
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


@rule(Severity.WARNING, Nodes(("logical", "power")))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the part that another reader would not take together."""
    left, _, right = node.children
    if node.kind == "power":
        if left.kind == "power":
            yield _report(line, left, "`**` goes from left to right")
        elif left.kind == "signed" and line.text[left.start] == "-" and _matters(line, node):
            yield _report(line, left, "a sign binds closer than `**`")
        return
    if _operator(line, left) in ("OR", "XOR") and _operator(line, node) == "AND":
        yield _report(line, left, "AND does not come before OR and XOR")
    if right.kind == "sum":
        yield _report(line, right, "some controls read logical operators along with `+` and `-`")


def _matters(line: Line, power: Node) -> bool:
    """Whether it makes a difference: an odd power has its base's sign, and what cannot be calculated is an error of its own."""
    exponent = constant(line.text, power.children[2], line.settings)
    odd = isinstance(exponent, float) and exponent % 2 == 1
    return not odd and not isinstance(constant(line.text, power, line.settings), ArithmeticFault)


def _report(line: Line, part: Node | Token, why: str) -> Report:
    return Report(Span(part.start, part.end), f"`{line.said(part)}` is taken together first: {why}; brackets make sure")


def _operator(line: Line, part: Node | Token) -> str:
    """Which of AND, OR and XOR joins a part; nothing if none does."""
    return (
        "".join(line.said(part.children[1]).split()).upper()
        if isinstance(part, Node) and part.kind == "logical"
        else ""
    )


def fix(broken: Broken) -> Iterator[Fix]:
    """Put into brackets what is taken together."""
    yield broken.replaced(f"[{broken.said}]", safe=True)
