"""Word that runs into text.

The longest known word wins: `#XPOSY` is `#XPOS` and the letter `Y`. A word that is declared later,
or that SmartCAM knows and this page does not, would change what is output.

Source: spec/cgt.md §2, §11, *Words*

Bad:

    #XPOSY
    ^^^^^^
    G#V100
     ^^^^^
    < X#XPOS#ANDY#YPOS >
            ^^^^^

Good:

    #XPOS Y
    TOOL#TOOL#EVAL(#V1=1)
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import template_of


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the word with the text."""
    for use in template_of(analysis).uses:
        rest = use.spelled.rest
        if rest:
            message = (
                f"`#{use.said}` is read as `#{use.spelled.name}` and the text `{rest}`; the longest known word wins"
            )
            yield Report(use.span, message, use.line)
