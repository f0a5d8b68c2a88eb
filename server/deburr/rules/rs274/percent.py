"""Percent sign that does not frame the program.

A `%` on a line of its own, before everything but blank lines, starts a program; a second one ends
it. With anything else on its line, or in a program that did not start with one, the control calls
it a bad character. A program that starts with `%` and has neither a second one nor M2 or M30 stops
with "File ended with no percent sign"; of a file that only defines subprograms that is only noted,
for it is called, not started.

Source: spec/rs274.md §1.1

Bad (whole):

    %part 7
     ^^^^^^
    G0 X1
    M2

Bad (whole):

    G0 X1
    %
    ^
    M2

Bad (whole):

    (housing)
    %
    ^
    G0 X1
    %
    ^

Bad (whole):

    %
    ^
    G0 X1

Good (whole):

    %
    G0 X1
    %

Good (whole):


    %
    G0 X1
    M2

Good (whole):

    %
    G0 X1
    M2
    %
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import appended, line_deleted
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.rs274._frame import ends, is_part, may_end, percents, starts_with_percent
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole())
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report text beside a percent sign, one that comes late, and one that lacks its other end."""
    lines = percents(analysis)
    for at, line in lines:
        for problem in line.problems:
            said = line.text[problem.start : problem.end]
            yield Report(whole(problem), f"`{said}` stands on a line with `%`, which must be alone", at)
    signs = [(at, _sign(line.text)) for at, line in lines if not line.problems]
    if lines and not starts_with_percent(analysis):
        message = "`%` comes too late to start the program, and ends only one that starts with `%`"
        yield from (Report(sign, message, at) for at, sign in signs)
    elif signs and len(lines) == 1 and not ends(analysis) and (is_part(analysis) or not may_end(analysis)):
        severity = Severity.INFO if is_part(analysis) else None
        message = "the program starts with `%` and has no second one, nor M2 or M30: the control stops at its end"
        yield from (Report(sign, message, at, severity=severity) for at, sign in signs)


def _sign(text: str) -> Span:
    at = text.index("%")
    return Span(at, at + 1)


def fix(broken: Broken) -> Iterator[Fix]:
    """Leave it alone on its line, take it out where it comes too late, add the second one."""
    message = broken.finding.message
    if "must be alone" in message and "(" not in broken.said:
        yield Fix("Make it a comment on a line of its own", (broken.edit(*broken.span, f"\n({broken.said})"),))
    elif "comes too late" in message:
        yield from line_deleted(broken)
    elif "no second one" in message:
        yield appended(broken, "%")
