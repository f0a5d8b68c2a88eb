"""What can be done about findings: the fixes of their rules, and comments that allow them. Each is proven: made in the program, the finding is gone and none is new."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.fix import cures, fixes_of, in_endings
from deburr.ide.refactor import Work
from deburr.mend import mending
from deburr.suppress import is_allowed
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from deburr.finding import Finding, Place
    from deburr.ide.view import View
    from deburr_grammar.document import Document

LOOKED_AT = 100
"""Findings of a selection that are looked at: nobody reads a longer list of what can be done."""
_ALLOWS = re.compile(r"deburr:[ \t]*allow[ \t]+")


class QuickFix(NamedTuple):
    """What is offered: its title, the finding that it is about, the edits, whether it is the thing to do."""

    title: str
    finding: Finding
    edits: tuple[Edit, ...]
    preferred: bool = False


def quick_fixes(view: View, findings: Iterable[Finding]) -> list[QuickFix]:
    """All that can be done about findings of a program, in its own text; of very many, about the first ones."""
    found: list[QuickFix] = []
    with Analysis(view.document, view.ruleset, view.file, view.host) as analysis:
        for finding in islice(findings, LOOKED_AT):
            if finding.place.file == view.file and finding.place.line < view.document.line_count:
                found += [*_mended(analysis, finding), *_allowed(analysis, finding)]
    return found


def _mended(analysis: Analysis, finding: Finding) -> Iterator[QuickFix]:
    """What its rule would do; the first is the thing to do."""
    proven = (fix for fix in fixes_of(analysis, finding) if cures(analysis, finding, fix.edits))
    for number, fix in enumerate(proven):
        yield QuickFix(fix.title, finding, in_endings(analysis.document, fix.edits), number == 0)


def _allowed(analysis: Analysis, finding: Finding) -> Iterator[QuickFix]:
    """A comment on the line, or one more name in the one that is there; if the line takes none, one on the line above."""
    document = analysis.document
    for edit in _comments(document, finding):
        after = document.edit(edit)
        moved = finding._replace(place=_below(finding, edit))
        same = _same_line(document, after, finding.place.line, moved.place.line)
        if same and is_allowed(after, moved) and cures(analysis, finding, [edit]):
            yield QuickFix(f"Allow `{finding.rule}` here", finding, in_endings(document, [edit]))
            return


def _comments(document: Document, finding: Finding) -> Iterator[Edit]:
    line = finding.place.line
    text = document.line(line)
    if match := _ALLOWS.search(text):
        at = Pos(line, match.end())
        yield Edit(at, at, f"{finding.rule}, ")
    said = [
        f"{opens}{'' if closes else ' '}deburr: allow {finding.rule}{closes}"
        for opens, closes in document.dialect.comments
    ]
    end, start = Pos(line, len(text.rstrip())), Pos(line, 0)
    yield from (Edit(end, end, f" {each}") for each in said)
    yield from (Edit(start, start, f"{each}\n") for each in said)


def _below(finding: Finding, edit: Edit) -> Place:
    lines = edit.text.count("\n")
    return finding.place._replace(line=finding.place.line + lines, end_line=finding.place.end_line + lines)


def _same_line(before: Document, after: Document, was: int, now: int) -> bool:
    """Whether a line means what it meant: the same faults, and the same parts but for comments."""
    old, new = before.node(was), after.node(now)
    kinds = [frozenset(kind for kind in node.kinds if "comment" not in kind.lower()) for node in (old, new)]
    return kinds[0] == kinds[1] and [p.kind for p in old.problems] == [p.kind for p in new.problems]


def fix_all(view: View) -> Work[tuple[Edit, ...]]:
    """The edits that make all safe fixes, until there are none."""
    done = yield from mending(view.document, lambda text: Analysis(text, view.ruleset, view.file, view.host))
    return tuple(_difference(view.document, done.document))


def _difference(before: Document, after: Document) -> Iterator[Edit]:
    """The lines in which two texts differ, as edits of the first."""
    if before is after:
        return
    old, new = ([each.line(at) for at in range(each.line_count)] for each in (before, after))
    head = next((at for at, (one, two) in enumerate(zip(old, new)) if one != two), min(len(old), len(new)))
    rest = min(len(old), len(new)) - head
    tail = next((at for at in range(rest) if old[-1 - at] != new[-1 - at]), rest)
    if len(old) == len(new):
        lines = (at for at in range(head, len(old) - tail) if old[at] != new[at])
        yield from (Edit(Pos(at, 0), Pos(at, len(old[at])), new[at]) for at in lines)
        return
    # Lines have come or gone: what stands between the first and the last difference is put anew.
    start, end = Pos(head, 0), Pos(len(old) - tail, 0)
    text = "".join(f"{line}\n" for line in new[head : len(new) - tail])
    yield from in_endings(before, [Edit(start, end, text if tail else text[:-1])])
