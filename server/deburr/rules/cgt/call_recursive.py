"""Section that calls itself.

The generator would go down until it runs out of room, and output the same lines again and
again on the way.

Source: spec/cgt.md §5.5

Bad:

    @
    @retract
    G53 Z0
    #CALL(retract)
    ^^^^^^^^^^^^^^
    @

Bad:

    #IF(#V1>3)<#CALL(LINE)>
               ^^^^^^^^^^^

Good:

    #CALL(retract)
    @
    @retract
    G53 Z0
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import target


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the call."""
    for call, section in template_of(analysis).calls():
        if call.name == "CALL" and target(call)[0] == section.name:
            yield Report(call.span, f"`{call.text}` stands in `@{section.name}` itself; it would never end", call.line)
