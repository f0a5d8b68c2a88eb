"""Blocks behind the end of the program.

M2 and M30 end the run. Behind them only blocks that a jump leads to and sections that are called
are reached.

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

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._program import BLOCK, entries, lines, number_of
from deburr_grammar.document import Document
from deburr_grammar.text import Span


@rule(Severity.INFO, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first block that is never reached."""
    reached, looked = entries(analysis), -1
    for line, node in lines(analysis, "M_END"):
        if line < looked or "DELETE" in node.kinds or "advanced" in node.kinds:
            continue
        looked = _next(analysis.document, line + 1)
        if looked >= analysis.document.line_count:
            return
        after = analysis.document.node(looked)
        number = number_of(after.text)
        entry = number is not None and (reached is None or number in reached)
        if "section" not in after.kinds and not entry and "M_END" not in after.kinds:
            start = len(after.text) - len(after.text.lstrip())
            yield Report(
                Span(start, len(after.text.rstrip())), "this block is never reached: the program ends before it", looked
            )


def _next(document: Document, line: int) -> int:
    """The next line that does something or starts a section, or the number of lines."""
    wanted = BLOCK | {"section", "nword"}
    numbers = range(line, document.line_count)
    return next((at for at in numbers if not wanted.isdisjoint(document.node(at).kinds)), document.line_count)
