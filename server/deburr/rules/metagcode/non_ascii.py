"""Character that is not ASCII, outside a comment.

Controls read ASCII. A degree sign, a typographic minus or a blank that does not break looks right
in the editor and stops the control, or is taken for something else.

Source: spec/metagcode.md §2, §6

Bad:

    G0 X1°
         ^
    G1 X−5 Y–2
        ^   ^
    #IF1 |Größe| equalto 1 n
            ^^
    #ENDIF1

Good:

    G0 X1 (90° left)
    G0 X2 ; Ø 5 |n|
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span

_FOREIGN = re.compile(r"[^\x00-\x7f]+")


@rule(Severity.WARNING, Text(r"[^\x00-\x7f]"))
def check(line: Line) -> Iterator[Report]:
    """Report each run of such characters. Of a line that is read only in part it is not known what is a comment."""
    if line.node.problems:
        return
    comments = [(node.start, node.end) for node in line.node.find("comment")]
    for run in _FOREIGN.finditer(line.text):
        if not any(start <= run.start() < end for start, end in comments):
            yield Report(
                Span(*run.span()), f"`{run[0]}` is not ASCII; the control may stop at it or take it for something else"
            )


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the sign of a keyboard that it looks like."""
    plain = broken.said.translate(_PLAIN)
    if plain.isascii():
        yield broken.replaced(plain)


_PLAIN = str.maketrans(
    {"\u00a0": " ", "\u2009": " ", "\u202f": " ", "\u2019": "'", "\u2018": "'"}
    | dict.fromkeys("\u2010\u2011\u2012\u2013\u2014\u2212", "-")
)
