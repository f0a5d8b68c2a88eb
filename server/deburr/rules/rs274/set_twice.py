"""Parameter that one line sets twice.

All settings of a line happen after all values of the line have been found, so the last one wins
and the others are lost.

Source: spec/rs274.md §4.3

Bad:

    #3=15 #3=6
          ^^
    #<a>=1 G0 X1 #< A >=2
                 ^^^^^^

Good:

    #3=15
    #3=6
    #4=#3 #5=#3
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import index, name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


def _may(line: Line, node: Node) -> bool:
    return any(setting.start != node.start for setting in line.node.find("setting"))


@rule(Severity.WARNING, Nodes(("setting",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report every setting but the first of each parameter, all at a line's first setting."""
    if next(line.node.find("setting")).start != node.start:
        return
    seen: set[object] = set()
    for setting in line.node.find("setting"):
        param = setting.node("param")
        if param is None:
            continue
        key = _key(line, param)
        if key in seen:
            said = line.said(param)
            yield Report(
                Span(param.start, param.end), f"`{said}` is set twice on this line; only the last setting counts"
            )
        seen.add(key)


def _key(line: Line, param: Node) -> object:
    """What tells parameters apart; an index that only the run knows, by how it is written: both are read before either is set."""
    named, number = name(line, param), index(line, param)
    if named is not None:
        return f"<{named}>"
    return round(number) if number is not None else "#" + "".join(line.said(param).split()).lower()
