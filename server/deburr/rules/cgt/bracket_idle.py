"""Bracket that can never print.

On every way to it, the words that it tests have been output, or were marked as output by `#UPDATE`, and nothing has
changed them or reset them since. So the codes and commands that stand in it, too, never come out. Nothing is said of a bracket
that would only repeat its words.

Source: spec/cgt.md §5.2

Bad:

    #UPDATE(#XPOS,#YPOS)
    <G00 X#XPOS#OR Y#YPOS>
    ^^^^^^^^^^^^^^^^^^^^^^

Bad:

    <X#XPOS>< Y#YPOS>
    <X#XPOS G43>
    ^^^^^^^^^^^^

Good:

    #UPDATE(#SPEED)
    <S#SPEED#OR#SPNDL M08>
    #RESET(#XPOS)
    <X#XPOS G43>
    <X#XPOS>
"""

from collections.abc import Iterator

from deburr.rule import Proven, Report, Severity, rule
from deburr.values.graph import Proof


@rule(Severity.WARNING, Proven())
def check(proof: Proof) -> Iterator[Report]:
    """Report the bracket."""
    yield Report(proof.span, proof.message)
