"""M code that does not exist.

The control stops with "Unknown m code used". M100 to M199 are left to the machine builder; above
that there is none: "M-code greater than 199". In a file of subprograms alone it is a warning: it may
belong to a machine that has codes of its own (REMAP). Codes that your machine remaps are named by the
setting `remap = ["M428"]` of `[rs274]`; nothing is said of them, nor of what stands beside them.

`M98` is known at the beginning of a line alone.

Source: spec/rs274.md §5

Bad:

    M55
    ^^^
    M200
    ^^^^
    M41 S100
    ^^^

Bad (whole):

    G0 X1 M98 P5
          ^^^
    M2
    o5
    M99

Good:

    M03 S100
    M62 P1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._unknown import CALLS, unknown
from deburr.rules.rs274._words import node, said
from deburr_grammar.text import Span

_LAST = 199


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the code."""
    for found in unknown(analysis, "M"):
        if found is None:
            yield None
            continue
        # A fraction is another fault: no M code has one.
        if "." not in found.code:
            word = node(found.line, found.word)
            if found.code == CALLS:
                message = f"behind other words the control knows no `{said(found.line, found.word)}`; it must come first on its line"
                yield Report(Span(word.start, word.end), message, found.at, severity=found.severity)
                continue
            beyond = f"; they end at M{_LAST}" if float(found.code[1:]) > _LAST else ""
            message = f"`{said(found.line, found.word)}` is no M code of this control{beyond}"
            yield Report(Span(word.start, word.end), message, found.at, severity=found.severity)
