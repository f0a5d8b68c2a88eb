"""Parameter number out of range.

Parameters run from 1 to 5601 in LinuxCNC and from 1 to 5399 in the SmithyCNC manual. The control
stops with "Parameter number out of range". Reported where the line alone decides the number, and where it
is out of range on every way on which the program comes to the line.

Source: spec/rs274.md §4.1

Bad:

    #0=1
    ^^
    #-1=3
    ^^^
    #5602=1
    ^^^^^
    G0 X#[3-3]
        ^^^^^^

Bad:

    #31=3
    o1 while [#31 GT 0]
      #31=[#31-1]
    o1 endwhile
    G0 X#5420 Y##31
               ^^^^

Bad (profile=smithy):

    #5400=1
    ^^^^^

Good:

    #1=1
    #5601=1

Good (profile=smithy):

    #5399=1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR, asked, index, literal
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

LAST = {"linuxcnc": 5601, "smithy": 5399}


@rule(Severity.ERROR, Nodes(("param",), where=lambda _, node: literal(node.children[1])))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the parameter."""
    number, last = index(line, node), LAST[line.settings["profile"]]
    if number is None or asked(line, node) or abs(number - round(number)) > NEAR or 1 <= round(number) <= last:
        return
    said = line.said(node)
    yield Report(Span(node.start, node.end), f"`{said}` is out of range; parameters are numbered 1 to {last}")
