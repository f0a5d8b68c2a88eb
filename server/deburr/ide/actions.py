"""What can be done about findings: the spelling that was meant, and a comment that allows the rule. Each is proven: made in the program, the finding is gone and none is new on its line."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.suppress import is_allowed
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from deburr.finding import Finding, Place
    from deburr.ide.view import View
    from deburr_grammar.document import Document

_MEANT = re.compile(r"did you mean `([^`]+)`\?")
_QUOTED = re.compile(r"`([^`]+)`")
_ALLOWS = re.compile(r"deburr:[ \t]*allow[ \t]+")


class Action(NamedTuple):
    """What is offered: its title, the finding that it is about, the edits, whether it is the thing to do."""

    title: str
    finding: Finding
    edits: tuple[Edit, ...]
    preferred: bool


def actions(view: View, findings: Iterable[Finding]) -> list[Action]:
    """All that can be done about findings of a program."""
    found: list[Action] = []
    for finding in findings:
        if finding.place.file == view.file and finding.place.line < view.document.line_count:
            found += [*_meant(view, finding), *_allowed(view, finding)]
    return found


def _meant(view: View, finding: Finding) -> Iterator[Action]:
    """The spelling that the message proposes, in place of what it quotes first."""
    meant, quoted = _MEANT.search(finding.message), _QUOTED.search(finding.message)
    if meant is None or quoted is None:
        return
    line, place = view.document.line(finding.place.line), finding.place
    said = line[place.col : place.end_col]
    at = said.lower().find(quoted[1].lower())
    old = quoted[1] if at >= 0 else said
    start = place.col + max(at, 0)
    # What is proposed may be the bare name within what is quoted, or all of it.
    edit = Edit(Pos(place.line, start), Pos(place.line, start + len(old)), meant[1])
    if _cures(view, finding, (edit,)):
        yield Action(f"Change to `{meant[1]}`", finding, (edit,), True)


def _allowed(view: View, finding: Finding) -> Iterator[Action]:
    """A comment on the line, or one more name in the one that is there; if the line takes none, one on the line above."""
    for edit in _comments(view.document, finding):
        after = view.document.edit(edit)
        moved = finding._replace(place=_below(finding, edit))
        if is_allowed(after, moved) and _same_line(view.document, after, finding.place.line, moved.place.line):
            yield Action(f"Allow `{finding.rule}` here", finding, (edit,), False)
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


def _cures(view: View, finding: Finding, edits: tuple[Edit, ...]) -> bool:
    """Whether the edits take away what lines alone decide of the finding, and bring nothing new there."""
    line = finding.place.line
    before = {each.rule for each in Analysis(view.document, view.ruleset, view.file, view.host).line_findings(line)}
    document = view.document.edit(*edits)
    after = {each.rule for each in Analysis(document, view.ruleset, view.file, view.host).line_findings(line)}
    return finding.rule not in after and after <= before
