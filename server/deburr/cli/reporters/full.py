"""The line of each finding in its surroundings with the place underlined, and the other places that explain it."""

from collections.abc import Iterator
from typing import TextIO

from deburr.cli.reporters.concise import statistics
from deburr.cli.result import Result
from deburr.cli.run import AROUND
from deburr.cli.style import Style, picture, plain
from deburr.finding import Finding, Place, Severity

__all__ = ["TEXT", "report", "statistics"]

TEXT = True
WIDEST = 160
_BEFORE = 40
_TAB = 4
Texts = dict[tuple[str, int], str]


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings, a blank line behind each."""
    for finding in result.findings():
        out.writelines(f"{line}\n" for line in _finding(finding, result.texts, style))
        out.write("\n")


def _finding(finding: Finding, texts: Texts, style: Style) -> Iterator[str]:
    severity, place = finding.severity, finding.place
    yield f"{style.paint(f'{severity.word}[{finding.rule}]', severity)}: {style.paint(plain(finding.message), 'bold')}"
    last = [each.line for each in (place, *(related.place for related in finding.related))]
    width = len(str(max(last) + 1 + AROUND))
    yield from _where("-->", place, width, style)
    yield from _frame(place, texts, width, style, severity, AROUND)
    for related in finding.related:
        yield from _where(":::", related.place, width, style)
        yield from _frame(related.place, texts, width, style, None, 0, plain(related.message))
    if finding.fix is not None:
        how = "safe" if finding.fix.safe else "not sure to be what is meant"
        yield f"{' ' * width} {style.paint('=', 'frame')} fix: {plain(finding.fix.title)} ({how})"


def _where(arrow: str, place: Place, width: int, style: Style) -> Iterator[str]:
    yield f"{' ' * width}{style.paint(arrow, 'frame')} {style.file(place.file)}:{place.line + 1}:{place.col + 1}"


def _frame(
    place: Place, texts: Texts, width: int, style: Style, severity: Severity | None, around: int, said: str = ""
) -> Iterator[str]:
    """The lines around a place; ``severity`` None: a place that only explains."""
    bar = style.paint("|", "frame")
    yield f"{' ' * width} {bar}"
    for line in _lines(place, texts, around):
        text = texts[place.file, line]
        here = line == place.line
        shown, under = _underlined(text, place.col, _end(place, text)) if here else _underlined(text, 0, 0)
        yield f"{style.paint(f'{line + 1:>{width}}', 'frame')} {bar} {shown}".rstrip()
        if here:
            mark = under.replace("^", "-") if severity is None else under
            tail = f"{mark.strip()} {said}".rstrip()
            yield f"{' ' * width} {bar} {' ' * (len(mark) - len(mark.lstrip()))}{style.paint(tail, severity or 'frame')}"
    yield f"{' ' * width} {bar}"


def _lines(place: Place, texts: Texts, around: int) -> list[int]:
    """The lines to show: blank ones at the edges are left out."""
    lines = [at for at in range(place.line - around, place.line + around + 1) if (place.file, at) in texts]
    while lines and lines[0] < place.line and not texts[place.file, lines[0]].strip():
        lines.pop(0)
    while lines and lines[-1] > place.line and not texts[place.file, lines[-1]].strip():
        lines.pop()
    return lines


def _end(place: Place, text: str) -> int:
    """Where the underline ends; a place that goes on over more lines is marked to its first line's end."""
    return max(place.col + 1, place.end_col if place.end_line == place.line else len(text))


def _underlined(text: str, start: int, end: int) -> tuple[str, str]:
    """The line as it is shown, cut to what fits, and the carets below it."""
    first = max(0, start - _BEFORE) if len(text) > WIDEST else 0
    cut = text[first : first + WIDEST]
    end = min(end, first + WIDEST)
    shown, under = _cells_of(cut, start - first, end - first)
    dots = ("..." if first else "", "..." if first + WIDEST < len(text) else "")
    return f"{dots[0]}{shown}{dots[1]}", f"{' ' * len(dots[0])}{under}".rstrip()


def _cells_of(cut: str, start: int, end: int) -> tuple[str, str]:
    """The text as a terminal shows it, and carets from one of its columns to another, which may lie behind it."""
    if cut.isascii() and cut.isprintable():
        return cut, " " * start + "^" * (end - start)
    shown, under = "", ""
    for col, char in enumerate(cut):
        cell = " " * (_TAB - len(under) % _TAB) if char == "\t" else picture(char)
        shown += cell
        under += ("^" if start <= col < end else " ") * (len(cell) if char == "\t" else _cells(char))
    return shown, under + "^" * (end - max(start, len(cut)))


def _cells(char: str) -> int:
    """How many cells of a terminal a character takes."""
    if char.isascii():
        return 1
    from unicodedata import combining, east_asian_width

    return 0 if combining(char) else 2 if east_asian_width(char) in "WF" else 1
