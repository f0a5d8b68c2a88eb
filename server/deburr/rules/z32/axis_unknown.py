"""Letter in G25 that is no axis.

Which letters are axes is set up per machine (setting `axes`); AA, AB and AC cannot stand for
any other address. In a word, a letter that is no axis is a parameter of the control.

Source: spec/z32.md §5, §6.5

Bad:

    G25XYF
         ^

Bad (axes=XZC):

    G25XYZ
        ^

Good (axes=XYZUVW):

    G25XYZ
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.z32._alias import axes
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("axis_alias",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the letters."""
    known = line.settings["axes"].upper()
    for col, letter in enumerate(axes(line, node), node.end - 3):
        if letter not in known:
            message = f"`{letter}` is no axis of this machine ({known}); if it should be, add it to the setting `axes`"
            yield Report(Span(col, col + 1), message)
