"""Blocks behind the end of the program.

M2 and M30 end the run. Behind them only blocks that a jump leads to and sections that are called
are reached; a block that neither leads to is never done. Empty blocks do no harm there.

Source: spec/z32.md §1, §11

Bad:

    M30
    G0 X1
    ^^^^^
    Y2

Good:

    !GON10-N20!
    M30
    N10 G0 X1
    N20
    M30
    :1
    G0 X1
"""

from collections.abc import Iterator, Set

from deburr.analysis import Analysis
from deburr.expand.z32.unit import ACTIVE
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._program import entries, jumps, lines, ready_jumps
from deburr_grammar.dialects.z32.forms import number_of
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span


@rule(Severity.INFO, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first block that is never reached."""
    targets, looked = entries(analysis), -1
    ends: set[float | None] = {jump.end for jump in jumps(analysis)}
    reached = None if targets is None else {*targets, *ends}
    for line, node in lines(analysis, "M_END"):
        if line < looked or "DELETE" in node.kinds or "advanced" in node.kinds:
            continue
        looked = _next(analysis.document, line + 1, reached)
        if looked >= analysis.document.line_count:
            return
        after = analysis.document.node(looked)
        if not _is_entry(after, reached) and "M_END" not in after.kinds:
            span = Span(len(after.text) - len(after.text.lstrip()), len(after.text.rstrip()))
            yield Report(
                span, "this block is never reached: the program ends before it, and no jump leads here", looked
            )


def _next(document: Document, line: int, reached: Set[float | None] | None) -> int:
    """The next line that does something or is an entry, or the number of lines."""
    numbers = range(line, document.line_count)
    found = (
        at for at in numbers if not ACTIVE.isdisjoint((node := document.node(at)).kinds) or _is_entry(node, reached)
    )
    return next(found, document.line_count)


def _is_entry(node: LineNode, reached: Set[float | None] | None) -> bool:
    """Whether a run can come to a line though the one before it does not go on: a section, or a block that a jump names."""
    number = number_of(node.text) if "nword" in node.kinds else None
    return "section" in node.kinds or (number is not None and (reached is None or number in reached))
