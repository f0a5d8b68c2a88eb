"""Comment that runs Python in the control.

LinuxCNC runs what stands behind `(PY,`, `(PYRUN,` and, at the very start of a line, `;py,`, and
loads its code anew at `(PYRELOAD)`. No such code is run here, so all that it changes is unknown.

Source: spec/rs274.md §1.5

Bad:

    (PY,self.params[100] = 3)
    ^^^^^^^^^^^^^^^^^^^^^^^^^
    (pyreload)
    ^^^^^^^^^^
    ;py,print("here")
    ^^^^^^^^^^^^^^^^^

Good:

    (python is not meant, only spoken of)
    ; py, a name
"""

import re
from collections.abc import Iterator

from deburr.rule import Line, Report, Severity, Text, rule
from deburr.rules.rs274._comments import active, comments, tail
from deburr_grammar.text import Span

_PYTHON = frozenset(("PY", "PYRUN", "PYRELOAD"))
_MESSAGE = "this runs Python in the control; it is not run here, and what it changes is unknown"


@rule(Severity.INFO, Text(r"[(;][ \t]*(?i:py(?:,|run,|reload))", signs="(;"))
def check(line: Line) -> Iterator[Report]:
    """Report the comment."""
    found = [comment for comment in comments(line) if active(line, comment) in _PYTHON]
    behind = tail(line)
    if behind and re.match(";py,", line.text):
        found.append(behind)
    yield from (Report(Span(comment.start, comment.end), _MESSAGE) for comment in found)
