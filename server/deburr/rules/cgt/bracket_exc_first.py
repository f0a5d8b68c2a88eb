"""Bracket whose words are all excluded.

`#EXC` takes every word behind it out of the test. In front of the first word it leaves nothing
to test, and the bracket is always output.

Source: spec/cgt.md §5.2, §11

Bad:

    <#EXC D#DOFF>
     ^^^^

Good:

    < #DCOMP#EXC D#DOFF >
"""

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.fixers import deleted
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.brackets import read_brackets, tests_of
from deburr.templates.items import Body


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the operator."""
    yield from parted(read_brackets(template_of(analysis)), _of)


def _of(bodies: Sequence[Body]) -> Iterator[Report]:
    for body in bodies:
        tests = tests_of(body)
        if tests.excluded and not tests.tested:
            operator = next(item for item in tests.early if item.name == "EXC")
            message = (
                f"`{operator.text}` stands before the first word, so nothing is tested and the bracket is always output"
            )
            yield Report(operator.span, message, operator.line)


fix = deleted
