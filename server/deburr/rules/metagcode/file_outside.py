"""Snippet outside the folder of snippets.

A snippet's name may go down into folders, with `/` or `\\`, but not up and not elsewhere: `..`,
absolute paths and drive letters are refused, so that a template reads no file that it should not.

Source: spec/metagcode.md §4, §6, §10

Bad:

    #FILE ..\\x.txt
          ^^^^^^^^
    #FILE mill/../../x.txt
          ^^^^^^^^^^^^^^^^
    #FILE /etc/x.txt
          ^^^^^^^^^^
    #FILE C:x.txt
          ^^^^^^^

Good:

    #FILE mill\\deep/pocket..txt
    -- Snippets/mill/deep/pocket..txt --
    G1 X0
"""

import re
from collections.abc import Iterator

from deburr.includes import leaves
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("file",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name."""
    name = node.find("NAME")
    if name is not None and "|" not in line.said(name) and leaves(line.said(name)):
        last = re.split(r"[\\/:]", line.said(name))[-1].strip()
        hint = f"write `{last}` for a file in it" if last.strip(".") else "name a file in it"
        message = f"`{line.said(name)}` leaves the folder of snippets, which is refused; {hint}"
        yield Report(Span(name.start, name.end), message)
