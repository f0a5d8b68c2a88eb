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

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import Use


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the word with the text."""
    yield from parted(template_of(analysis).uses, _of)


def _of(uses: Sequence[Use]) -> Iterator[Report]:
    for use in uses:
        rest = use.spelled.rest
        if rest:
            message = (
                f"`#{use.said}` is read as `#{use.spelled.name}` and the text `{rest}`; the longest known word wins"
            )
            yield Report(use.span, message, use.line)
