"""`@LINE` that outputs no position.

It runs for every straight cut. If it never mentions `#XPOS`, `#YPOS` or `#ZPOS`, or lacks an axis
that `@RAP` outputs, cuts are lost and the tool goes straight to the next rapid move.

Source: spec/cgt.md §7

Bad (whole):

    @START
    G90
    @
    @LINE
    ^^^^^
    G01 F#FEED
    @
    @END
    M30
    @

Bad (whole):

    @START
    G90
    @
    @RAP
    G00< X#XPOS>< Z#ZPOS>
    @
    @LINE
    ^^^^^
    G01< X#XPOS>
    @
    @END
    M30
    @

Good (whole):

    @START
    G90
    @
    @RAP
    G00< X#XPOS>< Z#ZPOS>
    @
    @LINE
    #CALL(axes)
    @
    @axes
    #EVAL(#V1=#XPOS*2)
    X#V1 Z#ZPOS
    @
    @END
    M30
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import template_of
from deburr.templates.symbols import POSITIONS
from deburr.templates.template import Template, target


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the header."""
    template = template_of(analysis)
    section = template.by_name.get("LINE")
    if section is None:
        return
    used = _mentioned(template, "LINE")
    if not used:
        message = "`@LINE` outputs none of `#XPOS`, `#YPOS`, `#ZPOS`; straight cuts would be lost"
        yield Report(section.span, message, section.line)
    elif missing := [f"`#{name}`" for name in POSITIONS if name in _mentioned(template, "RAP") - used]:
        message = f"`@LINE` never outputs {', '.join(missing)}, which `@RAP` does; cuts along that axis would be lost"
        yield Report(section.span, message, section.line)


def _mentioned(template: Template, name: str) -> set[str]:
    """The positions that a section, or one that it calls, mentions anywhere, lines with syntax faults included."""
    calls: dict[str, set[str]] = {}
    for call, section in template.calls():
        calls.setdefault(section.name, set()).add(target(call)[0])
    waiting, reached = [name], {name}
    while waiting:
        behind = calls.get(waiting.pop(), set()) - reached
        reached |= behind
        waiting += behind
    names = {use.spelled.name for use in template.uses if use.section.name in reached}
    faulty = " ".join(node.text for _, node in template.lines if node.problems).upper()
    return {each for each in POSITIONS if each in names or f"#{each}" in faulty}
