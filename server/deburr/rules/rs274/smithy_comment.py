"""Comment behind a semicolon, in the SmithyCNC profile.

LinuxCNC takes a `;` and what follows for a comment; the SmithyCNC manual knows only comments in
brackets. Reported in the profile `smithy`.

Source: spec/rs274.md §1.4

Bad (profile=smithy):

    G0 X1 ; first hole
          ^^^^^^^^^^^^

Good (profile=smithy):

    G0 X1 (first hole; second one later)

Good:

    G0 X1 ; first hole
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr.rules.rs274._comments import tail
from deburr_grammar.text import Span
from deburr_grammar.tree import Node


@rule(Severity.WARNING, Nodes(("line",), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the comment."""
    comment = tail(line) if line.settings["profile"] == "smithy" else None
    if comment:
        end = len(line.text.rstrip())
        yield Report(Span(comment.start, end), "the SmithyCNC manual knows no `;` comments; write `(...)`")


def fix(broken: Broken) -> Iterator[Fix]:
    """Write it as a comment in brackets."""
    inner = broken.said[1:].strip()
    if inner and not any(sign in inner for sign in "()"):
        yield broken.replaced(f"({inner})", safe=True)
