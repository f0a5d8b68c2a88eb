"""Block that is never closed.

An `if`, `while`, `do` or `repeat` without its end may run by luck, as long as the control
need not look for that end; when it does, it reads to the end of the file and stops.

Source: spec/rs274.md §6

Bad:

    o1 if [1]
    ^^^^^
      G0 X1

Good:

    o1 if [1]
      G0 X1
    o1 endif
"""

from collections.abc import Iterator

from deburr_grammar.structure import Fault, StructureFault

from deburr.rule import Note, Report, Severity, Structure, rule


@rule(Severity.ERROR, Structure((Fault.UNCLOSED,)))
def check(fault: StructureFault) -> Iterator[Report]:
    """Report the opener."""
    opener = fault.at.bracket
    related = ()
    if fault.other is not None:
        other = fault.other.bracket
        related = (Note(fault.other.line, other.span, f"`o{other.label} {other.word}` is reached first"),)
    message = f"`o{opener.label} {opener.word}` is never closed; `o{opener.label} {_END[opener.kind]}` is missing"
    yield Report(opener.span, message, fault.at.line, related)


_END = {"if": "endif", "while": "endwhile", "do": "while", "repeat": "endrepeat"}
