"""Section that exists twice.

The generator runs one section of a name. Which of two it takes is not documented, so the
program would depend on luck.

Source: spec/cgt.md §7

Bad:

    @
    @LINE
    ^^^^^
    X#XPOS
    @

Good:

    @
    @DWELL
    G4 P#DWELL
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report every section of a name but the first."""
    template = template_of(analysis)
    for section in template.sections:
        first = template.by_name.get(section.name, section)
        if not section.faulty and section is not first:
            message = f"`@{section.name}` exists already; the generator can run only one of them"
            yield Report(
                section.span, message, section.line, (Note(first.line, first.span, f"the first `@{section.name}`"),)
            )
