"""Comment that allows a rule which does not exist.

A comment `deburr: allow RULE` with a name that no rule of the language has silences nothing.
Names are separated by commas; a reason follows `--`.

Source: interface.md, *suppression*

Bad:

    {(}deburr: allow {dialect}.line-too-lonk{)}
                     ^^^^^^^^^^^^^^^^^^^^^^^
    {(}deburr: allow -- the feed is set by hand{)}
       ^^^^^^^^^^^^^

Good:

    {(}deburr speaks here{)}
"""

from collections.abc import Iterator

from deburr.finding import Finding, Fix
from deburr.fix import Broken
from deburr.rule import Notice, Noticed, Report, Severity, rule
from deburr.rules.common._names import name_left_out
from deburr.suggest import suggestion


@rule(Severity.WARNING, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the name."""
    said = f"`{notice.said}` is no rule of this language" if notice.said else "no rule is named"
    yield Report(notice.span, f"{said}; nothing is allowed by it", notice.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Spell the name as a rule that speaks here, or take it out."""
    names = {each.rule for line in (broken.line, broken.line + 1) for each in _speaking(broken, line)}
    near = suggestion(broken.said, sorted(names)).partition("`")[2].partition("`")[0]
    if near:
        yield broken.replaced(near)
    else:
        yield from name_left_out(broken)


def _speaking(broken: Broken, line: int) -> list[Finding]:
    return broken.analysis.line_findings(line) if line < broken.document.line_count else []
