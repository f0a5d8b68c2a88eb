"""More than the generator can work through.

Brackets nest up to 32 deep, and a `#REPEAT` runs up to 100,000 times.

Source: spec/cgt.md §8, §11, *Errors*

Bad:

    <#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>
                                                                                                                                    ^

Bad:

    #REPEAT(100001)<M08>
            ^^^^^^

Good:

    <#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1<#V1>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>>
    #REPEAT(100000)<M08>
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import Body, template_of
from deburr_grammar.text import Span

DEEPEST = 32
MOST_PASSES = 100_000


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the bracket that is too deep, and the count."""
    template = template_of(analysis)
    for section in template.sections:
        for body in _too_deep(section.body):
            if body.opener:
                yield Report(
                    body.opener.span,
                    f"this bracket stands {DEEPEST + 1} deep; {DEEPEST} are the limit",
                    body.opener.line,
                )
    for line, node in template.lines:
        for repeat in node.find("repeat"):
            count = repeat.children[2]
            if count.kind == "NUMBER" and float(said := node.text[count.start : count.end]) > MOST_PASSES:
                yield Report(
                    Span(count.start, count.end), f"`{said}` passes are too many; {MOST_PASSES} are the limit", line
                )


def _too_deep(body: Body) -> Iterator[Body]:
    waiting = [(body, 0)]
    while waiting:
        inner, depth = waiting.pop()
        if depth > DEEPEST:
            yield inner
        else:
            waiting += [(part, depth + 1) for part in inner.parts if isinstance(part, Body)]
