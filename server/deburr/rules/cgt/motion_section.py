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

from collections.abc import Iterator, Mapping, Sequence, Set

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.symbols import POSITIONS
from deburr.templates.template import Template, Use, target


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the header."""
    template = template_of(analysis)
    section = template.by_name.get("LINE")
    if section is None:
        return
    names: dict[str, set[str]] = {}

    def take(uses: Sequence[Use]) -> None:
        for use in uses:
            if use.spelled.name in POSITIONS:
                names.setdefault(use.section.name, set()).add(use.spelled.name)

    yield from parted(template.uses, take)
    used = _mentioned(template, names, "LINE")
    if not used:
        message = "`@LINE` outputs none of `#XPOS`, `#YPOS`, `#ZPOS`; straight cuts would be lost"
        yield Report(section.span, message, section.line)
    elif missing := [f"`#{name}`" for name in POSITIONS if name in _mentioned(template, names, "RAP") - used]:
        message = f"`@LINE` never outputs {', '.join(missing)}, which `@RAP` does; cuts along that axis would be lost"
        yield Report(section.span, message, section.line)


def _mentioned(template: Template, names: Mapping[str, Set[str]], name: str) -> set[str]:
    """The positions that a section, or one that it calls, mentions anywhere, lines with syntax faults included. ``names``: those on lines that can be read, by sections."""
    calls: dict[str, set[str]] = {}
    for call, section in template.calls():
        calls.setdefault(section.name, set()).add(target(call)[0])
    waiting, reached = [name], {name}
    while waiting:
        behind = calls.get(waiting.pop(), set()) - reached
        reached |= behind
        waiting += behind
    found = {each for section in reached for each in names.get(section, ())}
    faulty = " ".join(node.text for node in template.faulty).upper()
    return {each for each in POSITIONS if each in found or f"#{each}" in faulty}
