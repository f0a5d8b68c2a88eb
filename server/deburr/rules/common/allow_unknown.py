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

from deburr.rule import Notice, Noticed, Report, Severity, rule


@rule(Severity.WARNING, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the name."""
    said = f"`{notice.said}` is no rule of this language" if notice.said else "no rule is named"
    yield Report(notice.span, f"{said}; nothing is allowed by it", notice.line)
