"""More than 20 `<` open at once.

The control nests expressions 20 deep, those in index brackets included, and refuses the line
beyond that. A `<` around a single value is not needed, parentheses do as well.

Source: spec/z32.md §7

Bad:

    HA<<<<<<<<<<<<<<<<<<<<<1>>>>>>>>>>>>>>>>>>>>>
                          ^^^
    PAL[<<<<<<<<<<<<<<<<<<<<<1>>>>>>>>>>>>>>>>>>>>>]5
                            ^^^

Good:

    HA<<<<<<<<<<<<<<<<<<<<1>>>>>>>>>>>>>>>>>>>>
    X<1> Y<1> Z<1> HA<1> HB<1> HC<1> HD<1> HE<1> HF<1> HG<1> HI<1> HJ<1> HK<1> HL<1> HM<1> HN<1> HO<1> HP<1> HQ<1> HR<1> HS<1>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule, whole
from deburr.rules.z32._depth import beyond

DEPTH = 20


@rule(Severity.ERROR, Text(r"[<&](?:[^\n<&]*[<&]){20}"))
def check(line: Line) -> Iterator[Report]:
    """Report each expression that is one too deep."""
    for node in beyond(line.node.tree, ("angle",), DEPTH):
        yield Report(whole(node), f"`{line.said(node)}` is nested {DEPTH + 1} deep in `<`; the control takes {DEPTH}")
