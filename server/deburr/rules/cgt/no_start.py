"""Template without `@START`.

The section runs before the first element. Without it the program has no header: no units, no
plane, no first tool.

Source: spec/cgt.md §1, §7

Bad (whole):

    @END
    ^^^^
    G90
    @

Good (whole):

    @START
    G90
    @
    @END
    M30
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import first_place
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the template at its first header."""
    template = template_of(analysis)
    place = first_place(analysis, template)
    if place is not None and not any(section.name == "START" for section in template.sections):
        line, span = place
        yield Report(span, "the template has no section `@START`, so the program has no opening commands", line)
