"""Variable in the name of a snippet.

Snippets are put in before variables are filled in, so a `#FILE` line cannot depend on one. Choose
between snippets with `#IF`; all of them are read, only one is generated.

Source: spec/metagcode.md §4, §6, §10

Bad:

    #FILE |s|
          ^^^
    #FILE drill_|Mat.txt
          ^^^^^^^^^^^^^^

Good:

    #IF1 |s| equalto drill a
    #FILE drill.txt
    #ENDIF1
    -- Snippets/drill.txt --
    G81 X0 Y0 Z-5 R2
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("file",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    name = node.find("NAME")
    if name is not None and "|" in line.said(name):
        message = f"`{line.said(name)}` has a bar in it, but snippets are put in before variables have values; choose with `#IF`"
        yield Report(Span(name.start, name.end), message)
