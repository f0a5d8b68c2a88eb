"""Setting of a parameter that only the control sets.

The current tool and position (#5400 to #5413, #5420 to #5428) and the predefined names cannot be
set. The control stops with "Parameter is readonly" or "Cannot assign to read-only parameter".

Source: spec/rs274.md §4.1, §4.2

Bad:

    #5420=1
    ^^^^^
    #<_x>=3
    ^^^^^
    #[5400+13]=1
    ^^^^^^^^^^

Good:

    #5399=1
    #5414=1
    #5419=1
    #5429=1
    #<_mine>=3
    #<x>=3
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._values import index, literal, name
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

READ_ONLY = (range(5400, 5414), range(5420, 5429))


def _may(line: Line, node: Node) -> bool:
    param = node.node("param")
    named = name(line, param) if param is not None else None
    return param is not None and (literal(param.children[1]) if named is None else named.startswith("_"))


@rule(Severity.ERROR, Nodes(("setting",), where=_may))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the parameter on the left."""
    param = node.node("param")
    if param is None:
        return
    number, named = index(line, param), name(line, param)
    # The smithy profile has no such numbers at all: there `param-range` speaks.
    known = line.settings["profile"] != "smithy" and number is not None and any(round(number) in r for r in READ_ONLY)
    if known or named is not None and _predefined(line, named):
        yield Report(
            Span(param.start, param.end), f"`{line.said(param)}` can only be read; the control refuses to set it"
        )


def _predefined(line: Line, named: str) -> bool:
    entry = line.node.dialect.codes.entry("variable", named) if named.startswith("_") else None
    return entry is not None and entry.more.get("access") == "read" and not {"since", "pattern"} & set(entry.more)
