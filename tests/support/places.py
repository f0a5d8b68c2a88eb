"""Whether what is said of a file stands in it."""

from __future__ import annotations

from collections.abc import Sequence

from deburr.finding import Finding, Place
from deburr_grammar.text import Span


def check_finding(finding: Finding, lines: Sequence[str]) -> None:
    """A finding stands in the file, marks something that is there, and says something."""
    assert finding.message
    check_place(finding.place, lines)


def check_place(place: Place, lines: Sequence[str]) -> None:
    """A place in a file of these lines."""
    assert 0 <= place.line <= place.end_line < len(lines), place
    assert 0 <= place.col <= len(lines[place.line]), place
    assert 0 <= place.end_col <= len(lines[place.end_line]), place
    assert (place.line, place.col) <= (place.end_line, place.end_col), place


def check_span(line: int, span: Span, lines: Sequence[str]) -> None:
    """Columns of a line; of one that is empty its first, so that an editor shows something."""
    assert 0 <= line < len(lines), (line, span)
    assert 0 <= span.start <= span.end <= max(len(lines[line]), 1), (line, span, lines[line])
