"""One line a finding: `file:row:column: severity rule message`."""

from collections.abc import Iterable
from typing import TextIO

from deburr.cli.result import Result, Row
from deburr.cli.style import Style, plain

TEXT = True


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings."""
    for finding in result.findings():
        place = finding.place
        where = f"{style.paint(style.file(place.file), 'bold')}:{place.line + 1}:{place.col + 1}:"
        severity = style.paint(finding.severity.word, finding.severity)
        mark = " [*]" if finding.fix is not None and finding.fix.safe else ""
        out.write(f"{where} {severity} {style.paint(finding.rule, 'bold')}{mark} {plain(finding.message)}\n")


def statistics(rows: Iterable[Row], out: TextIO, style: Style) -> None:
    """Write how often each rule spoke."""
    rows = list(rows)
    width = max((len(str(row.times)) for row in rows), default=0)
    for row in rows:
        severity = style.paint(row.severity.word, row.severity)
        out.write(f"{row.times:>{width}}\t{style.paint(row.rule, 'bold')}\t{severity}\t{row.summary}\n")
