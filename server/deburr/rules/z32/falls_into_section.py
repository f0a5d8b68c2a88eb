"""Main part that runs on into a section.

The start of a section stops nothing: a program that has no M30 before its first section runs on into
it. If the section is called, too, and ends in G26, its blocks are done once more than they are called, and then the
control of a main program stops at the G26. Only a subprogram could mean that.

Source: spec/z32.md §6.4, §11

Bad (whole):

    %
    G0 X1
    !GOP5!
    G0 Z100
    ^^^^^^^
    :5 DRILL
    G1 Z-5 F100
    G26

Good (whole):

    %
    G0 X1
    !GOP5!
    G0 Z100
    M30
    :5 DRILL
    G1 Z-5 F100
    G26

Good (whole):

    %
    :1 ROUGHING
    G0 X1
    :2 FINISHING
    G0 X2
    M30
"""

from collections.abc import Iterator
from posixpath import basename, dirname, normpath

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Note, Report, Severity, Whole, rule
from deburr.rules.z32._called import Program, all_sections
from deburr.rules.z32._flow import flowing, ready
from deburr.rules.z32._program import called, last_block, lines, numbers_of, within
from deburr_grammar.dialects.z32.forms import section_number
from deburr_grammar.text import Span


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the last block before each such section, unless the file is a subprogram itself."""
    sections = all_sections(analysis)
    returns = numbers_of(analysis, "G26")
    if not sections or not returns or returns[0] < sections[0].first or _is_stored(analysis):
        return
    targets = _called(analysis)
    entered = [each for each in sections if _number(each) in targets and within(returns, each.first, each.last)]
    last = last_block(analysis, 0, sections[0].first)
    if not entered or last is None:
        return
    ways = yield from flowing(analysis, 0, analysis.document.line_count, returns=True)
    for section in entered if ways is not None else ():
        yield None
        if ways is not None and ways.reaches(0, section.first):
            yield _report(analysis, section, targets[_number(section)])


def _report(analysis: Analysis, section: Program, call: tuple[int, Span]) -> Report:
    at = last_block(analysis, 0, section.first)
    assert at is not None
    text, said = analysis.document.line(at), analysis.document.line(section.first).strip()
    message = f"the main part runs on into `{said}`, which is called as a subprogram, and stops at the G26 there; M30 is missing behind this block"
    return Report(
        Span(len(text) - len(text.lstrip()), len(text.rstrip())), message, at, (Note(*call, "it is called here"),)
    )


def _called(analysis: Analysis) -> dict[int | None, tuple[int, Span]]:
    """The sections that are called by a number that stands there, with the place of their first call."""
    found: dict[int | None, tuple[int, Span]] = {}
    for at, node in lines(analysis, "call"):
        for call in node.find("call"):
            number = called(Line(node, analysis.settings), call)
            if number is not None:
                found.setdefault(number, (at, Span(call.start, call.end)))
    return found


def _number(section: Program) -> int | None:
    return section_number(section.analysis.document.line(section.first))


def _is_stored(analysis: Analysis) -> bool:
    """Whether calls lead to files, so that a section of this one is no subprogram, or this file is such a subprogram."""
    if analysis.settings["cmos-dir"]:
        return True
    root = str(analysis.settings["file-root"])
    return bool(root) and basename(dirname(analysis.file)) == basename(normpath(root))


def fix(broken: Broken) -> Iterator[Fix]:
    """End the main part behind this block."""
    end = len(broken.text)
    yield Fix("Add `M30`", (broken.edit(end, end, f"\n{broken.indent}M30"),))
