"""Argument that a subprogram reads and no call passes.

The control takes 0 for it without a word. It is said where all calls are known, none of them passes the argument, and the
subprogram neither sets it nor asks for it in a condition, as one does for arguments that may be left out.

Source: spec/rs274.md §6

Bad:

    o<drill> sub
      G0 X#1 Y#2
      G0 Z#3
          ^^
    o<drill> endsub
    o<drill> call [10] [20]
    o<drill> call [15] [25]

Good:

    o<drill> sub
      G0 X#1 Y#2
      o1 if [#3 EQ 0]
        #3=5
      o1 endif
      G0 Z[0-#3]
    o<drill> endsub
    o<drill> call [10] [20]

Good:

    o<drill> sub
      G0 X#1 Y#2
    o<drill> endsub
    o<drill> call [10]
    o<drill> call [10] [20]
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._files import World, ready_world, said, world_of
from deburr.rules.rs274._frame import is_part
from deburr.rules.rs274._held import Call, Role, Use
from deburr.rules.rs274._program import Program, Sub
from deburr_grammar.document import Document

_ARGUMENTS = range(1, 31)
_MOST = 5
"""So many calls are named."""
_ASKING = frozenset(("IF", "ELSEIF", "WHILE", "REPEAT"))


@rule(Severity.WARNING, Whole(ready_world))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first read of each argument."""
    world = world_of(analysis)
    main = world.main
    if not main.calls or not main.sound or world.nested or is_part(analysis) or not _are_known(world):
        return
    calls: dict[str | None, list[Call]] = {}
    for call in main.calls:
        calls.setdefault(call.label, []).append(call)
    for sub in main.subs:
        yield None
        if sub.label in calls and sub.label is not None and len(main.by_label[sub.label]) == 1:
            passed = max(_passed(main.document, call) for call in calls[sub.label])
            yield from _unpassed(main, sub, calls[sub.label], passed)


def _are_known(world: World) -> bool:
    """Whether the file has all calls: none goes elsewhere, from where others may come back, and none goes by a number or who knows where."""
    calls = world.main.calls
    return not world.reached and all(
        call.label in world.main.by_label and not call.fanuc and not call.faulty for call in calls
    )


def _unpassed(main: Program, sub: Sub, calls: list[Call], passed: int) -> Iterator[Report]:
    own = main.uses_in(sub)
    if any(use.name is None and use.number is None for use in own):
        return
    arguments = [use for use in own if use.number in _ARGUMENTS]
    spared = {use.number for use in arguments if use.role is not Role.READ or _asks(main.document, use)}
    for use in arguments:
        number = use.number or 0
        if use.role is Role.READ and number > passed and number not in spared:
            spared.add(number)
            related = tuple(Note(call.line, call.span, "called here") for call in calls[:_MOST])
            message = f"no call of `{said(sub.label)}` passes an argument `#{number}`; the control takes 0 for it"
            yield Report(use.span, message, use.line, related)


def _asks(document: Document, use: Use) -> bool:
    return not document.node(use.line).kinds.isdisjoint(_ASKING)


def _passed(document: Document, call: Call) -> int:
    """The number of arguments of a call; a cycle that follows a contour passes none."""
    o_line = next(document.node(call.line).find("o_line"), None)
    return sum(part.kind == "group" for part in o_line.nodes()) if o_line is not None else 0
