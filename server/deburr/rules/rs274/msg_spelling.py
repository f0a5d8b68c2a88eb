"""Message in a spelling that newer controls take for a comment.

The SmithyCNC manual allows blanks anywhere in `MSG,`. LinuxCNC allows them only in front: with any
other blank the text is a plain comment, and the operator sees nothing. So it is with DEBUG, PRINT
and LOG.

Source: spec/rs274.md §1.5

Bad:

    ( m s g , clamp the part)
    ^^^^^^^^^
    (MSG ,clamp the part)
    ^^^^^^
    (DEBUG , x #5420)
    ^^^^^^^^

Good:

    (MSG, clamp the part)
    ( msg,clamp the part)
    (message for the next shift, please)
"""

import re
from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Report, Severity, Text, rule
from deburr.rules.rs274._comments import comments
from deburr_grammar.text import Span

_B = r"[ \t]*"
_WORDS = ("msg", "debug", "print", "log")
_SPACED = "|".join(_B.join(word) for word in _WORDS)
PATTERN = rf"(?i:\({_B}(?!(?:{'|'.join(_WORDS)}),)({_SPACED}){_B},)"
_PATTERN = re.compile(PATTERN)


@rule(Severity.INFO, Text(PATTERN, signs="("))
def check(line: Line) -> Iterator[Report]:
    """Report how the comment starts."""
    for comment in comments(line):
        if match := _PATTERN.match(line.text, comment.start, comment.end):
            word = "".join(match[1].split()).upper()
            message = f"LinuxCNC takes this for a plain comment and shows nothing; write `({word},`"
            yield Report(Span(*match.span()), message)


def fix(broken: Broken) -> Iterator[Fix]:
    """Write it as LinuxCNC reads it."""
    yield broken.replaced(broken.quoted[-1])
