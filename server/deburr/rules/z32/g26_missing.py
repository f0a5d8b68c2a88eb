"""Subprogram that runs off its end.

A program that is called by GOP, GOS or L254 goes back at G26. Without one the control reads on to
the end of the file or of the section; it goes back there too, but nobody can see that the
end was meant, and what is added behind it later is run.

Source: spec/z32.md §6.4

Bad:

    !GOP1!
    M30
    :1 DRILL
    G1 Z-5 F100
    G0 Z5
    ^^^^^
    :2

Bad (file-root=icamfs):

    !:L254-SUBS\\DRILL!
           ^^^^^^^^^^
    -- icamfs/SUBS/DRILL --
    G1 Z-5 F100
    G0 Z5

Good:

    !GOP1!
    M30
    :1 DRILL
    !IF HA>1; GON10!
    G1 Z-5 F100
    N10 G0 Z5
    G26
"""

from collections.abc import Generator, Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.z32._called import Program, calls, main_part, programs_of
from deburr.rules.z32._flow import flowing, ready
from deburr.rules.z32._program import last_block
from deburr_grammar.text import Span


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the last block of a section of this file, or the call of another one, once for each program."""
    programs, seen = programs_of(analysis), set()
    for at, node, call in calls(main_part(analysis)):
        program = programs.called(analysis, node, call)
        if program is None or (program.file, program.first) in seen:
            continue
        seen.add((program.file, program.first))
        if (yield from _runs_off(program)):
            part, (line, span) = call.children[1], _end(program)
            called, said = Span(part.start, part.end), node.text[call.start : call.end]
            if program.analysis is analysis:
                message = f"the section that `{said}` calls runs off its end; `G26` is missing behind this block"
                yield Report(span, message, line, (Note(at, called, "it is called here"),))
            else:
                message = f"what `{said}` calls runs off the end of its file; `G26` is missing there"
                yield Report(called, message, at, (Note(line, span, "the last block", program.file),))


def _runs_off(program: Program) -> Generator[None, None, bool]:
    ways = yield from flowing(program.analysis, program.first, program.last, returns=True)
    yield
    return ways is not None and ways.reaches(program.first, program.last) is True


def _end(program: Program) -> tuple[int, Span]:
    """The last block of a program, or the line that starts it."""
    found = last_block(program.analysis, program.first, program.last)
    line = program.first if found is None else found
    text = program.analysis.document.line(line)
    start, end = len(text) - len(text.lstrip()), len(text.rstrip())
    return line, Span(start, end) if start < end else Span(0, 1)


def fix(broken: Broken) -> Iterator[Fix]:
    """End the section behind this block."""
    if "behind this block" in broken.finding.message:
        end = len(broken.text)
        yield Fix("Add `G26`", (broken.edit(end, end, f"\n{broken.indent}G26"),))
