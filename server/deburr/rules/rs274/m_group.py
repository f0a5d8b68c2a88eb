"""Two M codes of one modal group on a line.

Codes of one group exclude each other, also where one would think that both could be meant:
`M7` and `M8` are one group, and so are `M6` and `M61`. The control stops with "Two m codes used
from same modal group".

Source: spec/rs274.md §5

Bad:

    M3 S100 M4
            ^^
    M7 M8
       ^^
    M0 M1
       ^^
    M48 M50 P0
        ^^^
    M3 S100 M3
            ^^

Good:

    M3 S100 M8
    M7
    M8
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import moved_above, split
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._parting import copy_left_out, line_of
from deburr.rules.rs274._words import clashes
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report each code behind the first of its group."""
    yield from clashes(line, "M", "write one of them on a line of its own")


_TOGETHER = frozenset(("M7", "M8"))
_STOPS, _ENDS = frozenset(("M0", "M1", "M60")), frozenset(("M2", "M30"))


def fix(broken: Broken) -> Iterator[Fix]:
    """Write them on two lines where both hold one after the other: coolants, and a stop before the end. Elsewhere only one was meant."""
    _, found, starts = line_of(broken)
    at = starts.index(broken.span.start)
    before = set(found.codes[:at])
    if found.codes[at] in _TOGETHER and before & _TOGETHER - {found.codes[at]}:
        yield from moved_above(broken)
    elif found.codes[at] in _ENDS and before & _STOPS and at == len(starts) - 1:
        yield from split(broken)
    else:
        yield from copy_left_out(broken)
