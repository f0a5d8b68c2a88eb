"""Bracket without any word of its own.

A bracket is output if a word that stands directly in it has changed. Without one there is
nothing to test: it is always output, and the bracket only looks like a condition. Words in
brackets inside it, or in parentheses, do not count.

Source: spec/cgt.md §5.2, §11

Bad:

    <G90>
    ^^^^^

Bad:

    <<X#XPOS>>
    ^^^^^^^^^^
    <#EVAL(#V1=#XPOS)>
    ^^^^^^^^^^^^^^^^^^
    <>
    ^^

Bad:

    <
    ^
    G90
    >

Good:

    <G#V1>
    G90
    <T#NTOOL>#ELSE< T0>
"""

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.brackets import extent, read_brackets, tests_of
from deburr.templates.items import Body


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the bracket."""
    yield from parted(read_brackets(template_of(analysis)), _of)


def _of(bodies: Sequence[Body]) -> Iterator[Report]:
    for body in bodies:
        tests = tests_of(body)
        if not tests.tested and not tests.excluded:
            assert body.opener
            yield Report(
                extent(body), "no word stands directly in this bracket, so it is always output", body.opener.line
            )


def fix(broken: Broken) -> Iterator[Fix]:
    """What is always output stands there without its bracket."""
    start, end = broken.span
    if broken.finding.place.end_line == broken.line and broken.said[:1] == "<" and broken.said[-1:] == ">":
        inner = broken.said[1:-1]
        yield Fix("Take the bracket away", (broken.edit(start, end, inner),)) if inner else broken.deleted(start, end)
