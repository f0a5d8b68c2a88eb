"""More than the generator can work through.

Brackets nest up to 32 deep, a `#REPEAT` runs up to 100,000 times, and sections call each other up to 64 deep; a
line that a `#REPEAT` makes longer and longer ends with 1,000,000 characters.

Source: spec/cgt.md §8, §11, *Errors*

Bad:

    <#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>
                                                                                                                                    ^

Bad:

    #REPEAT(100001)<M08>
            ^^^^^^

Bad (input=sample.cl):

    #CALL(one)
    @
    @one
    #CALL(two)
    @
    @two
    #CALL(one)
          ^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Bad (input=sample.cl):

    #EVAL(#V1=100001)
    #REPEAT(#V1)<M08>
            ^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    <#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>
    #REPEAT(100000)<M08>
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import DEEPEST, Body
from deburr.templates.template import Placed, Template
from deburr_grammar.text import Span

MOST_PASSES = 100_000


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the bracket that is too deep, and the count."""
    template = template_of(analysis)
    yield from parted(template.bodies, _of_bodies)
    yield from parted(template.of("repeat"), partial(_of_items, template))


def _of_bodies(bodies: Sequence[Body]) -> Iterator[Report]:
    for body in bodies:
        # Deeper ones say nothing new.
        if body.opener and body.depth == DEEPEST + 1:
            message = f"this bracket stands {DEEPEST + 1} deep; {DEEPEST} are the limit"
            yield Report(body.opener.span, message, body.opener.line)


def _of_items(template: Template, items: Sequence[Placed]) -> Iterator[Report]:
    for item, _, _ in items:
        assert item.node is not None
        count = item.node.children[2]
        said = template.text(item.line)[count.start : count.end]
        if count.kind == "NUMBER" and float(said) > MOST_PASSES:
            message = f"`{said}` passes are too many; {MOST_PASSES} are the limit"
            yield Report(Span(count.start, count.end), message, item.line)
