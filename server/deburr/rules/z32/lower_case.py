"""Lower-case letter in a program.

Z32 programs are written in upper case. Small letters are read all the same here; a control may
refuse them. Comments and the names of files may hold any.

Source: spec/z32.md §2

Bad:

    g0 X1
    ^
    X<ha+1>
      ^^

Good:

    G0 X1 (any case in a comment)
"""

from collections.abc import Iterator

from deburr.fix import corrected, safe
from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

_FREE = ("COMMENT", "TAIL", "REST", "PATH", "STRING", "CONFIG_NAME", "LANGLE", "RANGLE")


@rule(Severity.INFO, Text("[a-z]"))
def check(line: Line) -> Iterator[Report]:
    """Report the first word of a line that holds one."""
    for token in tokens(line.node.tree):
        said = line.said(token)
        if token.kind not in _FREE and said != said.upper():
            yield Report(Span(token.start, token.end), f"`{said}` is read as `{said.upper()}`; a control may refuse it")
            return


fix = safe(corrected)
