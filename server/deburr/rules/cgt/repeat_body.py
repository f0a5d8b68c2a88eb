"""`#REPEAT` without a body.

What is repeated stands in a bracket behind the command, on the same line or on the next one.

Source: spec/cgt.md §3, §5.6

Bad:

    #REPEAT(3)
    ^^^^^^^^^^

Bad:

    #REPEAT(3) M08
    ^^^^^^^^^^
    #REPEAT(3)#XPOS
    ^^^^^^^^^^

Good:

    #REPEAT(3)<M08>
    #REPEAT(3) // pierce
    <
    M08
    >
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the command."""
    template = template_of(analysis)
    heads: set[int] = set()
    yield from parted(template.bodies, lambda some: heads.update([id(body.head) for body in some if body.head]))
    for item, _, _ in template.of("repeat"):
        if id(item) not in heads and item.line not in template.faulty_lines:
            yield Report(item.span, f"`{item.text}` repeats nothing; a body `<...>` must follow", item.line)
