"""Declaration outside `@DECLARE`.

Words are declared once, before anything runs. In any other section the generator does not know
the command.

Source: spec/cgt.md §5.1

Bad:

    #INT #passes
    ^^^^^^^^^^^^

Bad:

    @
    @DELCARE
    ^^^^^^^^
    #INT #passes
    #DEC #depth
    @
    @DWELL
    #REPEAT(#passes)<G04 P#depth>

Good:

    @DECLARE
    #INT #passes
    @
    @DWELL
    #REPEAT(#passes)<G04 P1>
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import misspelt_declare
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the declaration; where the section's name is misspelt, that."""
    template = template_of(analysis)
    misspelt = misspelt_declare(template)
    for section in misspelt:
        message = f"`@{section.name}` declares words, which only `@DECLARE` may; did you mean `@DECLARE`?"
        yield Report(section.span, message, section.line)
    for item, section, _ in template.of("declaration"):
        if section.reading != "declare" and section not in misspelt:
            yield Report(item.span, f"`{item.text}` declares outside `@DECLARE`; move it there", item.line)


fix = did_you_mean
