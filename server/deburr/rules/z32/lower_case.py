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

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Text, rule
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import tokens

_FREE = ("COMMENT", "TAIL", "REST", "PATH", "STRING", "CONFIG_NAME", "LANGLE", "RANGLE")


@rule(Severity.INFO, Text("[a-z]"))
def check(line: Line) -> Iterator[Report]:
    """Report the first word of a line that holds one."""
    for span in _lower(line.node):
        said = line.text[span.start : span.end]
        yield Report(span, f"`{said}` is read as `{said.upper()}`; a control may refuse it")
        return


def fix(broken: Broken) -> Iterator[Fix]:
    """Write all words of the line in upper case."""
    edits = [broken.edit(start, end, broken.text[start:end].upper()) for start, end in _lower(broken.node)]
    yield Fix("Write the line in upper case", tuple(edits), safe=True)


def _lower(node: LineNode) -> Iterator[Span]:
    for token in tokens(node.tree):
        said = node.text[token.start : token.end]
        if token.kind not in _FREE and said != said.upper():
            yield Span(token.start, token.end)
