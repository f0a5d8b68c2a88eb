"""Call with more than 30 arguments.

They become #1 to #30 of the subprogram. With a 31st the control stops with "Too many subroutine
parameters".

Source: spec/rs274.md §6, §9

Bad:

    o<p> sub
    o<p> endsub
    o<p> call [1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][31]
                                                                                                        ^^^^

Good:

    o<p> sub
    o<p> endsub
    o<p> call [1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][1][30]
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

MOST = 30


@rule(Severity.ERROR, Nodes(("o_line",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report what is too much."""
    if node.find("CALL") is None:
        return
    arguments = [part for part in node.nodes() if part.kind == "group"]
    if len(arguments) > MOST:
        yield Report(
            Span(arguments[MOST].start, arguments[-1].end),
            f"the call has {len(arguments)} arguments; a subprogram takes {MOST}, `#1` to `#{MOST}`, and the control refuses more",
        )
