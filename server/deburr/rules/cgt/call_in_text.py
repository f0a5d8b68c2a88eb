"""Call behind text of the same line.

A line is written when it ends, but the called section writes its own lines at once. So what
stands in front of the call is written first, as a line of its own.

Source: spec/cgt.md §5.5

Bad:

    S#SPEED M03 #CALL(coolant)
                ^^^^^^^^^^^^^^
    @
    @coolant
    M08
    @

Bad:

    X#XPOS#IF(#V1>3)<#CALL(TOOLCHG)>
                     ^^^^^^^^^^^^^^

Bad:

    G0 <
    #CALL(TOOLCHG)
    ^^^^^^^^^^^^^^
    #SPEED
    >

Good:

    #CALL(TOOLCHG) M8
    #IF(#V1>3)<M9>#ELSE<#CALL(TOOLCHG)>
    G0
    #CALL(TOOLCHG)
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import split
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import DEEPEST, Body, Item


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the call."""
    template = template_of(analysis)
    for section in template.sections:
        found: list[Item] = []
        _walk(section.body, False, found)
        for call in found:
            if call.line not in template.faulty_lines:
                message = (
                    f"what stands before `{call.text}` is written as a line of its own; put the call on its own line"
                )
                yield Report(call.span, message, call.line)


def _walk(body: Body, collected: bool, found: list[Item]) -> bool:
    """Whether text may wait to be written behind a body, if that was so before it."""
    line: int | None = None
    entry = collected
    for part in body.parts:
        opener = part if isinstance(part, Item) else part.opener
        assert opener is not None
        collected = collected and line in (None, opener.line)
        line = opener.line
        if isinstance(part, Body):
            before = entry if part.kind == "else" else collected
            entry = collected
            collected = (part.depth <= DEEPEST and _walk(part, before, found)) or collected
            line = part.closer.line if part.closer else line
        elif part.kind == "call" and part.name == "CALL":
            found += [part] if collected else []
            collected = False
        else:
            collected = collected or part.printed
    return collected


def fix(broken: Broken) -> Iterator[Fix]:
    """Begin a line with the call, if it stands in no bracket."""
    before = broken.text[: broken.span.start]
    if "<" not in before:
        yield from split(broken)
