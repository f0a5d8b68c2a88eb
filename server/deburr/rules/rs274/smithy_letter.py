"""Letter that the SmithyCNC control does not know.

`@` and `^` for polar coordinates and `$` for a spindle are LinuxCNC's; the SmithyCNC manual's table
of letters lacks them. Reported in the profile `smithy`.

Source: spec/rs274.md §1

Bad (profile=smithy):

    G0 @1 ^45
       ^  ^

Bad (profile=smithy):

    M3 S100 $1
            ^

Good (profile=smithy):

    G0 X1 Y45
    M3 S100

Good:

    M3 S100 $0
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("word",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the letter."""
    letter = line.text[node.start]
    if letter in "@^$" and line.settings["profile"] == "smithy":
        yield Report(Span(node.start, node.start + 1), f"`{letter}` is LinuxCNC's; the SmithyCNC control lacks it")
