"""Negative value where the control takes none.

A feed rate, a spindle speed, a tool number, a count and the number of a code cannot be negative,
and a dwell of -1 is taken for none at all. The control stops, as with "Negative f word used".

Source: spec/rs274.md §5

Bad:

    F-1
    ^^^
    S[1-2]
    ^^^^^^
    T-1
    ^^^
    G-1
    ^^^
    M-3
    ^^^

Bad:

    G4 P-1
       ^^^

Bad:

    F100
    G81 X1 Z-1 R1 L-2
                  ^^^

Good:

    F100 S-0
    G4 P1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import literal
from deburr.rules.rs274._words import value, words
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

_TAKES_NONE = {
    "F": "a feed rate",
    "S": "a spindle speed",
    "T": "a tool number",
    "G": "a G code",
    "M": "an M code",
    "L": "a count",
}
_NO_DWELL = -1.0
"""By this value the interpreter tells that there is no P word (spec/rs274-experiments.md)."""


def _may(line: Line, node: Node) -> bool:
    letter, number = line.text[node.start].upper(), node.children[-1]
    return letter in (*_TAKES_NONE, "P", "H") and not isinstance(number, Token) and literal(number)


@rule(Severity.ERROR, Nodes(("word",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the word."""
    letter, number = line.text[node.start].upper(), value(line, node)
    if number is None:
        return
    if letter in _TAKES_NONE and number < 0:
        what = _TAKES_NONE[letter]
    elif letter == "P" and number == _NO_DWELL and "G4" in words(line).has:
        what = "the time of a dwell"
    elif letter == "H" and number < 0 and not words(line).has.isdisjoint(("G43", "G43.2")):
        what = "the number of a tool offset"
    else:
        return
    yield Report(
        Span(node.start, node.end), f"`{line.said(node)}` is negative; {what} cannot be, the control stops here"
    )
