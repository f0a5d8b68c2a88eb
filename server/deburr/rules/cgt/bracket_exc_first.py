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

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import deleted
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import template_of
from deburr.templates.brackets import read_brackets, tests_of


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the operator."""
    for body in read_brackets(template_of(analysis)):
        tests = tests_of(body)
        if tests.excluded and not tests.tested:
            operator = next(item for item in tests.early if item.name == "EXC")
            message = (
                f"`{operator.text}` stands before the first word, so nothing is tested and the bracket is always output"
            )
            yield Report(operator.span, message, operator.line)


fix = deleted
