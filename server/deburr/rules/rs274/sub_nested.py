"""Subprogram defined inside another.

Definitions do not nest; the control stops with "Nested subroutine definition", and some versions
silently do the wrong thing. An O-word without a command starts a program that M98 calls, so it
stands in no subprogram either; where a word is missing behind it, write that.

Source: spec/rs274.md §6

Bad:

    o1 sub
    o2 sub
    ^^^^^^
    o2 endsub
    o1 endsub

Bad:

    o100 sub
      G0 X1
    o200
    ^^^^
      G0 X2
    o100 endsub
    o100 call

Good:

    o1 sub
    o1 endsub
    o2 sub
    o2 endsub
    o1 call
    o2 call
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._files import ready_world, world_of
from deburr.rules.rs274._o_words import end, note, said
from deburr_grammar.structure import Fault, StructureFault
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the inner definition, and an O-word that starts a program in a subprogram that is called."""
    for fault in analysis.document.faults:
        if fault.fault is Fault.REGION_NESTED:
            yield _nested(fault)
    world = world_of(analysis)
    for line, _ in world.main.bare if world.main.sound else ():
        sub = world.main.sub_at(line)
        if sub is not None and not world.is_uncalled(sub):
            o_line = next(analysis.document.node(line).find("o_line"))
            span = Span(o_line.start, o_line.end)
            text = analysis.document.line(line)[span.start : span.end]
            message = f"`{text}` has no command: it starts a program, which cannot stand inside a subprogram"
            yield Report(span, message, line, (Note(sub.start, sub.span, "is open here"),))


def _nested(fault: StructureFault) -> Report:
    assert fault.other is not None
    inner, outer = fault.at.bracket, fault.other.bracket
    message = f"{said(inner)} stands inside {said(outer)}; {end(outer)} must come first"
    return Report(inner.span, message, fault.at.line, (note(fault.other, "is open here"),))
