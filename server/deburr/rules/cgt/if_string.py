"""Numeric test of a text.

`#IF` compares numbers. A text that holds a number is taken for it; any other text is not, and
the run ends there. `#IFSTR` compares texts.

Source: spec/cgt.md §5.4

Bad:

    #IF(#S1>3)<M08>
        ^^^

Bad:

    @DECLARE
    #STR #name
    @
    @DWELL
    #IF(#V1=1,#OR#name=#DATE)<M08>
                 ^^^^^
                       ^^^^^

Good:

    #IFSTR(#S1=3)<M08>
    #IF(STRLEN(#S1)>3)<M08>
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import Placed, Template
from deburr.templates.types import no_numbers
from deburr_grammar.text import Span


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the text."""
    template = template_of(analysis)
    yield from parted(template.of("if"), partial(_of_items, template))


def _of_items(template: Template, items: Sequence[Placed]) -> Iterator[Report]:
    for item, _, _ in items:
        tests = item.node.node("tests") if item.node else None
        text = template.text(item.line)
        for part in no_numbers(template.symbols, text, tests) if tests else ():
            message = f"`{text[part.start : part.end]}` is a text; compare it with `#IFSTR`"
            yield Report(Span(part.start, part.end), message, item.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """The command that compares texts."""
    before = broken.text[: broken.span.start].upper()
    at = before.rfind("#IF(")
    if at >= 0:
        yield Fix("Change to `#IFSTR`", (broken.edit(at, at + len("#IF"), "#IFSTR"),))
