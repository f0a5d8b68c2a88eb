"""Section that calls itself, or goes round in a circle.

The generator would go down until it runs out of room, and output the same lines again and
again on the way. `#GOTO` is a call that does not come back: sections of which each goes on in the
next, whatever the values are, never end either.

Source: spec/cgt.md §5.5, §8

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

Bad:

    @
    @there
    G0 X1
    #GOTO(back)
    ^^^^^^^^^^^
    @
    @back
    #IF(#V1>3)<X#XPOS>
    #GOTO(there)
    ^^^^^^^^^^^^
    @

Good:

    @
    @there
    #GOTO(back)
    @
    @back
    #IF(#V1>3)<#EXIT>
    #GOTO(there)
    @

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
from deburr.rules.cgt._template import template_of
from deburr.templates.items import Body, Item
from deburr.templates.template import Template, target

_LEAVES = ("call", "exit")
"""Items behind which it is not certain that the rest of a section runs."""

_SHOWN = 5
"""So many sections of a circle are named."""


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the call."""
    template = template_of(analysis)
    for call, section in template.calls():
        if call.name == "CALL" and target(call)[0] == section.name:
            yield Report(call.span, f"`{call.text}` stands in `@{section.name}` itself; it would never end", call.line)
    yield from _in_circles(template)


def _in_circles(template: Template) -> Iterator[Report]:
    onward = {name: call for name, section in template.by_name.items() if (call := _certain(section.body))}
    for name, call in onward.items():
        way = [name]
        while (to := target(onward[way[-1]])[0]) in onward and to not in way:
            way.append(to)
        if to == name:
            shown = [f"`@{each}`" for each in way[:_SHOWN]] + ["…"] * (len(way) > _SHOWN)
            circle = " → ".join((*shown, f"`@{name}`"))
            yield Report(call.span, f"`{call.text}` goes round in a circle, {circle}; it would never end", call.line)


def _certain(body: Body) -> Item | None:
    """The `#GOTO` by which a section is left whatever the values are; None if something before it may leave it otherwise."""
    for part in body.parts:
        if isinstance(part, Item):
            if part.kind in _LEAVES:
                return part if part.name == "GOTO" else None
        elif any(item.kind in _LEAVES for inner in part.bodies() for item in inner.items()):
            return None
    return None
