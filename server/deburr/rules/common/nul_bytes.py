"""NUL bytes or an end mark around the program.

Punched tapes lead in and run out with NULs, and old transfers end a file with the end mark ^Z.
They mean nothing and are skipped; a control that reads the file over another way may stop at
them. In the example `␀` is a NUL, `␚` a ^Z, and `{}` a program.

Source: interface.md, *input bytes*

Bad (whole):

    ␀␀␀{}
    ^^^
    ␀␚
    ^^

Good (whole):

    {}
"""

from collections.abc import Iterator

from deburr.rule import Notice, Noticed, Report, Severity, rule


@rule(Severity.INFO, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the padding."""
    yield Report(
        notice.span, f"{notice.said} skipped: padding of a tape or a transfer, no part of the program", notice.line
    )
