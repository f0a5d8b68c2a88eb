"""Two words of one letter on a line.

A line takes one word of each letter, except for G and M. The control does not choose one of
them: it stops with "Multiple x words on one line".

Source: spec/rs274.md §5

Bad:

    G0 X1 Y2 X3
             ^^
    F100 S500 F200
              ^^^^
    G4 P1 M62 P2
              ^^
    G0 X1 Y2 X1
             ^^

Good:

    G0 G90 X1 Y2
    M3 M8 S500
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._parting import copy_left_out
from deburr.rules.rs274._words import report, said, words
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report each word behind the first of its letter."""
    letters = words(line).letters
    for at, letter in enumerate(letters):
        first = letters.index(letter)
        if letter not in "GM" and at > first:
            yield report(
                line,
                at,
                f"`{said(line, at)}` is a second {letter} word beside `{said(line, first)}`; the control takes one on a line",
            )


fix = copy_left_out
