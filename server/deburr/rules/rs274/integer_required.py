"""Value that is no integer where one is required.

The number of a parameter, of a tool (T), of a tool offset (H), of an M code and a count (L) must be integers,
or no more than 0.0001 above one; the control stops with "Non integer value for integer".

Source: spec/rs274.md §1.2

Bad:

    #1.5=3
     ^^^
    G0 X#[3/2]
         ^^^^^
    #1.0002=3
     ^^^^^^

Bad:

    T1.5
    ^^^^
    M3.5
    ^^^^
    G43 H[3/2]
        ^^^^^^
    F100
    G81 X1 Z-1 R1 L1.5
                  ^^^^

Good:

    #1.00009=3
    #[4/2]=1
    T1.0
    M3.00 S100
"""

from collections.abc import Iterator
from math import floor

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import NEAR, asked, index, literal
from deburr.rules.rs274._words import value
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

_INTEGERS = {"T": "a tool number", "H": "a tool offset", "L": "a count", "M": "an M code"}


def _may(line: Line, node: Node) -> bool:
    number = node.children[-1]
    if node.kind == "word" and line.text[node.start].upper() not in _INTEGERS:
        return False
    return literal(number) and ("." in line.said(number) or not isinstance(number, Token))


@rule(Severity.ERROR, Nodes(("param", "word"), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the number, or the word."""
    if node.kind == "word":
        yield from _in_word(line, node)
        return
    number = index(line, node)
    if number is not None and abs(number - round(number)) > NEAR and not asked(line, node):
        said = node.children[1]
        yield Report(Span(said.start, said.end), f"`{line.said(said)}` is no integer; a parameter's number must be one")


def _in_word(line: Line, node: Node) -> Iterator[Report]:
    letter, number = line.text[node.start].upper(), value(line, node)
    if letter in _INTEGERS and number is not None and NEAR < number - floor(number) <= 1 - NEAR:
        yield Report(Span(node.start, node.end), f"`{line.said(node)}` is no integer; {_INTEGERS[letter]} must be one")
