"""Block or subprogram that is never closed.

An `if`, `while`, `do` or `repeat` without its end may run by luck, as long as the control need not
look for that end; when it does, it reads to the end of the file and stops. A `sub` without its
`endsub` always does.

Source: spec/rs274.md §6

Bad:

    o1 if [1]
    ^^^^^
      G0 X1

Bad:

    o1 while [0]
      o2 if [1]
      ^^^^^
    o1 endwhile

Bad:

    o<drill> sub
    ^^^^^^^^^^^^
      G0 X1

Good:

    o1 do
      o2 if [1]
      o2 endif
    o1 while [0]
"""

from collections.abc import Iterator

from deburr.blockfix import ended
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Structure, rule
from deburr.rules.rs274._o_words import end, misspelt, note, said
from deburr_grammar.structure import Fault, StructureFault


@rule(Severity.ERROR, Structure((Fault.UNCLOSED, Fault.REGION_UNCLOSED)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the opener."""
    opener = fault.at.bracket
    if misspelt(opener):
        return
    related = (note(fault.other, "is reached first"),) if fault.other is not None else ()
    yield Report(opener.span, f"{said(opener)} is never closed; {end(opener)} is missing", fault.at.line, related)


def fix(broken: Broken) -> Iterator[Fix]:
    """Add the missing end; that of a `do` has a condition, which only its writer knows."""
    end = broken.quoted[1]
    if "is missing" in broken.finding.message and not end.endswith("while"):
        yield from ended(broken, end)
