"""Comment that is meant to allow a rule and does not.

A finding is allowed by a comment `deburr: allow RULE`, in small letters and with its colon. Behind
any other word, such as `ignore` or `noqa`, the rule goes on speaking. Only comments that name a rule
or a language are looked at: burrs are a machinist's business, too.

Source: interface.md, *suppression*

Bad:

    {(}deburr: ignore {dialect}.line-too-long{)}
       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
    {(}DEBURR: ALLOW {dialect}.line-too-long{)}
       ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^

Good:

    {(}deburr: ignore the inner edges{)}
"""

from collections.abc import Iterator

from deburr.rule import Notice, Noticed, Report, Severity, rule


@rule(Severity.WARNING, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the comment as far as the name."""
    yield Report(notice.span, f"this allows nothing; did you mean `deburr: allow {notice.said}`?", notice.line)
