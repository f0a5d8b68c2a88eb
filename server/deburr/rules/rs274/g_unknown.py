"""G code that does not exist.

The control stops with "Unknown g code used", or with "G-code out of range" for a number above
99.9 or with more than one digit behind the point. In a file of subprograms alone it is a warning: it
may belong to a machine that has codes of its own (REMAP).

Source: spec/rs274.md §5

Bad:

    G12
    ^^^
    G1.5 X1
    ^^^^
    G100
    ^^^^
    G38.25 X1
    ^^^^^^
    G61.2
    ^^^^^

Good:

    G01 F100 X1
    G59.3
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._unknown import unknown
from deburr.rules.rs274._words import node, said
from deburr.suggest import suggestion
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the code."""
    for found in unknown(analysis, "G"):
        if found is None:
            yield None
            continue
        word = node(found.line, found.word)
        names = [each.name for each in analysis.dialect.codes.table("code") if each.name.startswith("G")]
        same = [name for name in names if name.partition(".")[0] == found.code.partition(".")[0]]
        hint = suggestion(found.code, same) or suggestion(found.code, names)
        message = f"`{said(found.line, found.word)}` is no G code of this control{hint}"
        yield Report(Span(word.start, word.end), message, found.at, severity=found.severity)


fix = did_you_mean
