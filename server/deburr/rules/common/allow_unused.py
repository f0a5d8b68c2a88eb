"""Comment that allows a rule which does not speak.

A comment `deburr: allow RULE` silences a rule on its line, or, alone on a line, on the next.
One that silences nothing is left over from a fault that is gone, or stands on the wrong line,
and would hide the next fault there: take the name out of it.

Source: interface.md, *suppression*

Bad:

    {(}deburr: allow {dialect}.line-too-long -- generated{)}
                     ^^^^^^^^^^^^^^^^^^^^^^^

Good:

    {(}deburr speaks here{)}
"""

from collections.abc import Iterator

from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Notice, Noticed, Report, Severity, rule
from deburr.rules.common._names import name_left_out


@rule(Severity.WARNING, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the name of the rule."""
    message = f"`{notice.said}` finds nothing here; the comment would hide the next fault, take the name out"
    yield Report(notice.span, message, notice.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Take the name out, and the comment with it if it names nothing else."""
    yield from name_left_out(broken, safe=True)
