"""Word of an axis that the machine does not have.

For the control the letter of an axis that it lacks is a bad character. The setting `axes` names
the axes of the machine; without it all nine of LinuxCNC are taken, and X, Y, Z, A, B and C in the
profile `smithy`.

Source: spec/rs274.md §5

Bad (axes=XYZ):

    G0 X1 W1
          ^^

Bad (axes=XZ):

    G0 X1 Y1 A1
          ^^ ^^

Bad (profile=smithy):

    G0 U1
       ^^

Good:

    G0 X1 A90

Good (profile=linuxcnc):

    G0 U1 V1 W1

Good (axes=XYZW):

    G0 X1 W1
"""

from collections.abc import Iterator

from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._words import report, said, words
from deburr_grammar.tree import Node

_LETTERS = "XYZABCUVW"
_BY_PROFILE = {"linuxcnc": _LETTERS, "smithy": "XYZABC"}


@rule(Severity.ERROR, Nodes(("line",), by_shape=True))
def check(line: Line, _: Node) -> Iterator[Report]:
    """Report the word."""
    axes = (line.settings["axes"] or _BY_PROFILE[line.settings["profile"]]).upper()
    for at, letter in enumerate(words(line).letters):
        if letter in _LETTERS and letter not in axes:
            yield report(
                line, at, f"`{said(line, at)}` moves an axis that this machine does not have; its axes are {axes}"
            )
