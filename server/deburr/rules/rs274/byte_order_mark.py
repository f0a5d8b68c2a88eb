"""Byte order mark before the program.

Editors that save "UTF-8 with BOM" put three bytes before the first line that no editor shows. The
control reads them as part of that line and stops with "Bad character '\\357' used". In the example
`⚑` is the mark, and `{}` a program.

Source: spec/rs274.md §1

Bad (whole):

    ⚑{}
    ^

Good (whole):

    {}
"""

from collections.abc import Iterator

from deburr.rule import Notice, Noticed, Report, Severity, rule


@rule(Severity.ERROR, Noticed())
def check(notice: Notice) -> Iterator[Report]:
    """Report the mark where the first line starts."""
    message = f"a {notice.said} stands before this line and the control stops at it; save the file as UTF-8 without BOM"
    yield Report(notice.span, message, notice.line)
