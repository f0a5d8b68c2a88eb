"""User parameter that a block both sets and reads.

Whether the new or the old value counts depends on the order in which the control works through
the block. Read here is from left to right; two blocks leave no doubt.

Source: spec/z32.md §6.1

Bad:

    HA10 X<HA>
           ^^
    X<HA> HA10
      ^^

Good:

    HA10
    G0 X<HA> Y0
    X<HA> HB<HB+1>
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token, tokens


@rule(Severity.WARNING, Text(r"[<\[&][^\n<\[&]*?[Hh][A-Za-z]"))
def check(line: Line) -> Iterator[Report]:
    """Report the first read of each parameter that another word of the block sets."""
    words = [] if "advanced" in line.node.kinds else list(line.node.find("word"))
    setters = {name: word for word in words if (name := _user(line, word.children[0]))}
    seen = set()
    for word in words:
        for token in tokens(word):
            name = _user(line, token)
            if token != word.children[0] and name in setters and setters[name] != word and name not in seen:
                seen.add(name)
                message = (
                    f"`{name}` is read and set in one block; which value counts depends on the control, use two blocks"
                )
                yield Report(Span(token.start, token.end), message)


def _user(line: Line, part: Node | Token) -> str:
    """The name of a user parameter; empty for everything else."""
    name = line.said(part).upper()
    return name if part.kind == "NAME" and len(name) == 2 and name[0] == "H" else ""
