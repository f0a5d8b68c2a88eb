"""Calls that go deeper than 32.

A program that calls itself before anything else can end it never comes back: the control stops
at the 33rd call that is under way. Reported are calls that go so deep on every run.

Source: spec/z32.md §6.4, §7

Bad:

    :1
    G0 X1
    !GOP1!
        ^

Bad:

    !GOP1!
    M30
    :1 (drill)
    G0 X1
    !GOP2!
    G26
    :2 (retract)
    !GOP1!
        ^
    G26

Bad (cmos-dir=cmos):

    !GOP1!
        ^
    -- cmos/1.z32 --
    G0 X1
    !GOP1!
    G26

Good:

    !GOP1!
    M30
    :1
    G0 X<HA>
    !IF HA>9; HA=0; GOP1!
    !HA=HA+1; IF HA<9; GOP1!
    G26
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.expand.z32.state import DEEPEST
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._called import Call, Program, all_sections, main_part, programs_of, sure_call


class _Chain(NamedTuple):
    """Calls, each made in the program that the one before it runs, and the programs that they run. ``round``: the last leads back."""

    calls: Sequence[Call]
    programs: AbstractSet[tuple[str, int]]
    round: bool


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the last call in this file of a chain that is too deep; once for all chains that share a program."""
    seen: set[tuple[str, int]] = set()
    judged: set[tuple[str, int]] = set()
    for root in (main_part(analysis), *all_sections(analysis)):
        if (root.file, root.first) in judged:
            continue
        chain = _chain(analysis, root)
        judged |= chain.programs
        own = [call for call in chain.calls if call.file == analysis.file]
        if own and (chain.round or len(chain.calls) > DEEPEST) and seen.isdisjoint(chain.programs):
            seen |= chain.programs
            yield Report(own[-1].span, _message(chain, own[-1]), own[-1].line, tuple(_notes(analysis, chain, own[-1])))


def _chain(analysis: Analysis, root: Program) -> _Chain:
    """The calls from a program on that every run makes, down to the first that is too deep."""
    programs, found, under_way = programs_of(analysis), list[Call](), {(root.file, root.first)}
    program: Program | None = root
    while program is not None and len(found) <= DEEPEST and (made := sure_call(program)) is not None:
        call, node, field = made
        program = programs.called(program.analysis, node, field)
        if program is not None:
            found.append(call)
            if (program.file, program.first) in under_way:
                return _Chain(found, under_way, True)
            under_way.add((program.file, program.first))
    return _Chain(found, under_way, False)


def _message(chain: _Chain, call: Call) -> str:
    if chain.round:
        how = (
            "calls the program that it stands in" if set(chain.calls) == {call} else "leads to a program that calls it"
        )
        return f"`{call.said}` {how} again and again; the control stops at {DEEPEST} calls in each other, a condition must end them"
    return f"`{call.said}` leads to {len(chain.calls)} calls in each other; the control takes {DEEPEST}"


def _notes(analysis: Analysis, chain: _Chain, shown: Call) -> Iterator[Note]:
    """The other calls of a chain that goes round."""
    for call in chain.calls[-8:] if chain.round else ():
        if call != shown:
            yield Note(call.line, call.span, "called here", None if call.file == analysis.file else call.file)
