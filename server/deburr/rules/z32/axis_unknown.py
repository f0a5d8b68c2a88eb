"""Letter in G25 that is no axis.

Which letters are axes is set up per machine (setting `axes`); AA, AB and AC cannot stand for
any other address.

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
from deburr.rules.z32._alias import letters
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("axis_alias",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the letters."""
    named, axes = letters(line, node), line.settings["axes"].upper()
    for col, letter in enumerate(named, node.end - len(named)) if len(named) == 3 else ():
        if letter not in axes:
            message = f"`{letter}` is no axis of this machine ({axes}); if it should be, add it to the setting `axes`"
            yield Report(Span(col, col + 1), message)
