"""What would mend a fault: edits that the fault's own rule makes of the program as it stands. Never made while a program is checked, never applied here.

A rule's file may hold `fix`, a function of a `Broken` or one of those in `deburr.fixers`: then the rule has a fix, at least for some of its findings.
A fix is safe only where it is certain what the program means: the control reads what it read before, or could only read that.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.suppress import is_allowed
from deburr_grammar.text import Edit, Pos, Span, line_starts, with_newlines

if TYPE_CHECKING:
    from deburr.finding import Finding
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_QUOTED = re.compile(r"`([^`]+)`")


class Broken(NamedTuple):
    """A fault where it stands: what a fix is made from."""

    analysis: Analysis
    finding: Finding

    @property
    def document(self) -> Document:
        """The program."""
        return self.analysis.document

    @property
    def line(self) -> int:
        """The line of the fault."""
        return self.finding.place.line

    @property
    def text(self) -> str:
        """The text of that line."""
        return self.document.line(self.line)

    @property
    def node(self) -> LineNode:
        """That line as it was read."""
        return self.document.node(self.line)

    @property
    def span(self) -> Span:
        """The columns of the fault."""
        return Span(self.finding.place.col, min(self.finding.place.end_col, len(self.text)))

    @property
    def said(self) -> str:
        """The text of the fault."""
        return self.text[self.span.start : self.span.end]

    @property
    def quoted(self) -> list[str]:
        """What the message quotes."""
        return _QUOTED.findall(self.finding.message)

    def edit(self, start: int, end: int, text: str) -> Edit:
        """An edit of the line."""
        return Edit(Pos(self.line, start), Pos(self.line, end), text)

    def replaced(self, text: str, *, safe: bool = False) -> Fix:
        """The fault's text is another."""
        return Fix(f"Change to `{text}`", (self.edit(*self.span, text),), safe)

    def inserted(self, col: int, text: str, *, safe: bool = False) -> Fix:
        """More text in the line."""
        return Fix(f"Insert `{text.strip()}`" if text.strip() else "Insert a blank", (self.edit(col, col, text),), safe)

    def deleted(self, start: int, end: int, *, safe: bool = False) -> Fix:
        """Less text in the line: with a blank beside it, and with the line if nothing else is on it."""
        title = f"Delete `{self.text[start:end].strip()}`"
        before, after = self.text[:start], self.text[end:]
        if not before.strip() and not after.strip():
            return Fix(title, (self.without_line(),), safe and not self.counts_lines)
        if before[-1:].isspace() or not before:
            end += len(after) - len(after.lstrip()) if not before.strip() else 0
            start = len(before.rstrip()) if before.strip() and (not after or after[0].isspace()) else start
        return Fix(title, (self.edit(start, end, ""),), safe)

    @property
    def counts_lines(self) -> bool:
        """Whether the program reads the number of a line, so that none may be taken out of it."""
        pattern = self.document.dialect.line_number
        return bool(pattern) and re.search(pattern, self.document.text.lower()) is not None

    def without_line(self) -> Edit:
        """The line is taken out, with its ending."""
        if self.line + 1 < self.document.line_count:
            return Edit(Pos(self.line, 0), Pos(self.line + 1, 0), "")
        start = Pos(self.line - 1, len(self.document.line(self.line - 1))) if self.line else Pos(0, 0)
        return Edit(start, Pos(self.line, len(self.text)), "")

    @property
    def indent(self) -> str:
        """The blanks before the line."""
        return self.text[: len(self.text) - len(self.text.lstrip())]


_MANY = 200
"""Edits of which each would cost more than to put all between them anew."""
_PROVEN = 500
"""Findings of a program whose fixes are tried: each costs as much as the check of a few lines, several times."""
_COMPARED = 50_000
"""Findings that are compared for all fixes of a program: each fix is held against all that its line and the blocks say."""
_LONG = 100
"""Characters of a line that cost as much to read anew as a finding to compare."""


def fixes_of(analysis: Analysis, finding: Finding) -> list[Fix]:
    """All that the rule of a finding would do about it, the best first; nothing where the finding stands in another file."""
    rule, place = analysis.ruleset.named(finding.rule.partition(".")[2]), finding.place
    fix = None if rule is None else rule.fix
    if fix is None or place.file != analysis.file or not 0 <= place.line < analysis.document.line_count:
        return []
    return list(fix(Broken(analysis, finding)))


def proven(analysis: Analysis, finding: Finding) -> Fix | None:
    """The first fix of a finding that holds as far as its lines and the blocks decide."""
    return next((fix for fix in fixes_of(analysis, finding) if cures(analysis, finding, fix.edits)), None)


def with_fixes(analysis: Analysis, findings: Iterable[Finding]) -> Iterator[Finding]:
    """The findings with what would mend them. Where there are very many, the last ones' rules are taken at their word."""
    findings = list(findings)
    blocks, on_line = len(analysis.document.faults), Counter(each.place.line for each in findings)
    compared = 0
    for number, finding in enumerate(findings):
        line = finding.place.line
        here = finding.place.file == analysis.file and line < analysis.document.line_count
        compared += blocks + on_line[line] + (len(analysis.document.line(line)) // _LONG if here else 0)
        fix = (
            proven(analysis, finding)
            if number < _PROVEN and compared < _COMPARED
            else next(iter(fixes_of(analysis, finding)), None)
        )
        yield finding if fix is None else finding._replace(fix=fix)


def applied(document: Document, edits: Iterable[Edit]) -> Document:
    """The program behind edits of which none touches another."""
    found = sorted(in_endings(document, edits))
    if len(found) > _MANY:
        return document.edit(as_one(document, found))
    return document.edit(*reversed(found))


def as_one(document: Document, edits: Sequence[Edit]) -> Edit:
    """Many edits, the first first, as one that puts all anew from the first to the last of them."""
    text = document.text
    starts = line_starts(text)
    places = [[starts[at.line] + at.col if at.line < len(starts) else len(text) for at in edit[:2]] for edit in edits]
    done, parts = places[0][0], []
    for edit, (start, end) in zip(edits, places):
        parts += [text[done:start], edit.text]
        done = end
    return Edit(edits[0].start, edits[-1].end, "".join(parts))


def in_endings(document: Document, edits: Iterable[Edit]) -> tuple[Edit, ...]:
    """The edits with the line ending of the program where they start a line."""
    if document.piece(0).chunk.ending(0) != "\r\n":
        return tuple(edits)
    return tuple(edit._replace(text=with_newlines(edit.text).replace("\n", "\r\n")) for edit in edits)


def cures(analysis: Analysis, finding: Finding, edits: Iterable[Edit]) -> bool:
    """Whether edits take away what lines and blocks decide of a finding, and bring nothing new: costs what they touch."""
    edits = sorted(edits)
    was = _said(analysis, {line for edit in edits for line in range(edit.start.line, edit.end.line + 1)})
    with Analysis(applied(analysis.document, edits), analysis.ruleset, analysis.file, analysis.host) as after:
        now = _said(after, set(_behind(edits)))
    same = (finding.rule, finding.message)
    if was[same] and now[same] >= was[same]:
        return False
    return not _by_rule(now) - _by_rule(was)


def _behind(edits: Iterable[Edit]) -> Iterator[int]:
    """The lines that edits, the first first, have touched, as they are numbered afterwards."""
    shift = 0
    for edit in edits:
        first = edit.start.line + shift
        yield from range(first, first + edit.text.count("\n") + 1)
        shift += edit.text.count("\n") - (edit.end.line - edit.start.line)


def _said(analysis: Analysis, lines: Iterable[int]) -> Counter[tuple[str, str]]:
    """What is said of lines, and of the blocks: rules and messages."""
    count = analysis.document.line_count
    found = [each for line in lines if line < count for each in analysis.line_findings(line)]
    for fault in analysis.document.faults if analysis.ruleset.on_structure else ():
        found += (each for each in analysis.fault_findings(fault) if not is_allowed(analysis.document, each))
    return Counter((each.rule, each.message) for each in found)


def _by_rule(said: Counter[tuple[str, str]]) -> Counter[str]:
    return Counter(rule for rule, _ in said.elements())
