"""Named parameter that is set and never read.

Only the program or subprogram that sets `#<depth>` can read it, so a value that it never reads is of no use: often the name
is spelled otherwise where it is read. Nothing is said of names that begin with `_`, which other programs
read, of numbered parameters, which the control keeps, of names in a comment that prints them, nor in files that only define subprograms.
It is not among the rules that speak unless asked to, because tools beside the control read names out of programs as well.

Source: spec/rs274.md §4.2

Bad:

    #<depth>=5
    ^^^^^^^^
    #<dept>=3
    G0 Z#<dept>

Good:

    #<depth>=5
    G0 Z#<depth>
    #<_total>=1
    #100=7
    #<seen>=2
    (DEBUG, seen #<seen>)
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._files import world_of
from deburr.rules.rs274._frame import is_part
from deburr.rules.rs274._held import Role

_NAMED = re.compile(r"#[ \t]*<([^<>\r\n]*)>")


@rule(Severity.INFO, Whole(), default=False)
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first setting of each name."""
    main = world_of(analysis).main
    named = [use for use in main.uses if use.name is not None and not use.name.startswith("_")]
    read = {use.name for use in named if use.role is not Role.SET}
    unread = {use.name: use for use in reversed(named) if use.role is Role.SET and use.name not in read}
    if not unread or is_part(analysis) or world_of(analysis).nested:
        return
    mentioned = _mentioned(analysis)
    for use in sorted(unread.values()):
        if mentioned.count(use.name or "") == sum(each.name == use.name for each in named):
            message = f"`#<{use.name}>` is set and never read; is it spelled otherwise where it is read?"
            yield Report(use.span, message, use.line)


def _mentioned(analysis: Analysis) -> list[str]:
    """All names behind a `#`, also those in comments."""
    texts = (piece.chunk.text for piece in analysis.document.pieces())
    return ["".join(said.split()).lower() for text in texts for said in _NAMED.findall(text)]
