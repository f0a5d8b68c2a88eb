"""Variable without a name.

Between two bars stands a name of at least one character; outer blanks do not count. A variable
without a name has no value, and an empty coordinate is not safe.

Source: spec/metagcode.md §2, §6, §10

Bad:

    G0 X||
        ^^
    G0 X| | Y|y|
        ^^^
    #IF1 || equalto 1 n
         ^^
    #ENDIF1

Good:

    G0 X| x | |y|
"""

from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.dialects.metagcode.forms import name
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens


@rule(Severity.ERROR, Text(r"\|[ \t]*\|"))
def check(line: Line) -> Iterator[Report]:
    """Report the bars. Where their number is odd, no bar is known to be the first of two."""
    if line.node.problems:
        return
    for token in tokens(line.node.tree):
        if token.kind == "VARIABLE" and not name(line.said(token)):
            yield Report(
                Span(token.start, token.end), f"`{line.said(token)}` is a variable without a name; it has no value"
            )
