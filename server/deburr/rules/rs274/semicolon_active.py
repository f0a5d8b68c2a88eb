"""Message behind a semicolon.

`;MSG,text` shows nothing, whatever the manual says: the interpreter acts only upon comments in
brackets.

Source: spec/rs274.md §1.5

Bad:

    ;MSG,clamp the part
    ^^^^^^^^^^^^^^^^^^^
    G0 X1 ; debug, x #5420
          ^^^^^^^^^^^^^^^^

Good:

    (MSG,clamp the part)
    ;(MSG,clamp the part)
    ; message for the next shift, please
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Text, rule
from deburr.rules.rs274._comments import tail
from deburr_grammar.text import Span

PATTERN = r"(?i:;[ \t]*(msg|debug|print|log|logopen|logappend|abort)[ \t]*,)"
_PATTERN = re.compile(PATTERN)


@rule(Severity.WARNING, Text(PATTERN, signs=";"))
def check(line: Line) -> Iterator[Report]:
    """Report the comment."""
    comment = tail(line)
    match = _PATTERN.match(line.text, comment.start) if comment else None
    if comment and match:
        word = match[1].upper()
        message = f"`;` makes this a plain comment, and `{word}` does nothing; write `({word},...)`"
        yield Report(Span(comment.start, len(line.text.rstrip())), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write it as a comment in brackets."""
    inner = broken.said[1:].strip()
    if not any(sign in inner for sign in "()"):
        yield broken.replaced(f"({inner})")
