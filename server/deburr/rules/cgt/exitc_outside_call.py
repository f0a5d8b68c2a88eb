"""`#EXITC` in a section that nothing calls.

It leaves a called section and goes on behind the `#CALL`. Where there is no call it acts as
`#EXIT` and ends the section.

Source: spec/cgt.md §5.5

Bad:

    #IF(#DWELL<=0)<#EXITC>
                   ^^^^^^

Bad (input=sample.cl):

    #IF(#XPOS>0)<#EXITC>
                 ^^^^^^
    @
    @DWELL
    #CALL(LINE)
    @
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #CALL(sample)
    @
    @sample
    #IF(#V2<#V3)<#EXITC>
    M08
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import target


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the command."""
    template = template_of(analysis)
    called = {target(call)[0] for call, _ in template.calls()}
    for item, section, _ in template.of("exit"):
        if item.name == "EXITC" and section.name not in called and not section.name.startswith("$"):
            message = f"nothing calls `@{section.name}`, so `{item.text}` ends it as `#EXIT` does; write `#EXIT`"
            yield Report(item.span, message, item.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the command that it acts as."""
    yield broken.replaced("#EXIT", safe=True)
