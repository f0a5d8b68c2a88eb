"""What is wrong with the form of a MetaGCODE text before any value is looked at: its lines, its blocks (spec/metagcode.md §4, §10).

The faults of a line are those that the rules on lines name, whether they are switched on or
not: a line that they refuse cannot be run.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from deburr.expand.job import SLICE
from deburr.expand.lines import reports
from deburr.expand.metagcode.gather import Gathered, Place
from deburr.expand.metagcode.lines import Directive
from deburr.fault import Fault
from deburr.finding import Severity
from deburr.rule import Nodes, Rule, Syntax, Text
from deburr.ruleset import RuleSet
from deburr_grammar.dialect import Bracket, Role
from deburr_grammar.dialects.metagcode.limits import NESTED

CROSSES = "block-crosses-file"
"""What is met where one program opens a block and a later one closes it: a warning, unlike all else."""


def line_faults(reached: Place, ruleset: RuleSet) -> Iterator[Fault | None]:
    """The faults in the form of a file's lines, in order; None now and then, where a run may be left."""
    rules = _refusing(ruleset)
    text = reached.source.text
    for piece in text.document.pieces():
        found = ((piece.line + index, rule, report) for index, rule, report in reports(piece, rules))
        for row, rule, report in sorted(found, key=lambda each: (each[0], each[2].span)):
            yield Fault(rule.short, text.file, row, report.span, report.message, reached.stack)
        yield None


def tie(gathered: Gathered) -> Iterator[Fault | None]:
    """Tie the two ends of each block together, innermost first; None now and then.

    What has no other end, or a wrong one, is a fault, and closes its block all the same.
    """
    blocks: list[tuple[int, Directive]] = []
    for at, step in enumerate(gathered.steps):
        if at % SLICE == 0:
            yield None
        if not isinstance(step, Directive):
            continue
        if step.bracket.role is Role.OPEN:
            blocks.append((at, step))
            if len(blocks) == NESTED + 1:
                yield _fault("limit", gathered, at, f"blocks are nested more than {NESTED} deep here, which is refused")
        elif not blocks:
            yield _fault("block-unopened", gathered, at, f"`{step.said}` closes nothing: no block is open here")
        else:
            other, _ = blocks.pop()
            gathered.partners[at], gathered.partners[other] = other, at
            if (fault := _ill_matched(gathered, other, at)) is not None:
                yield fault
    for at, step in blocks:
        yield _fault("block-unclosed", gathered, at, f"`{step.said}` is never closed")


def _ill_matched(gathered: Gathered, first: int, last: int) -> Fault | None:
    """What is wrong with the two ends of a block."""
    opener, closer = _directive(gathered, first), _directive(gathered, last)
    if not _tied(opener.bracket, closer.bracket):
        message = f"`{closer.said}` cannot close `{opener.said}`, the innermost open block"
        return _fault("block-mismatch", gathered, last, message)
    if opener.text is closer.text or gathered.places[first].program is gathered.places[last].program:
        return None
    message = f"the block `{opener.said}` is opened in one program and closed in another; neither can be read by itself"
    return _fault(CROSSES, gathered, last, message)


@lru_cache(maxsize=8)
def _refusing(ruleset: RuleSet) -> RuleSet:
    """The rules on lines that say what cannot be run, as they are where nothing is configured."""

    def refuses(rule: Rule) -> bool:
        return rule.severity is Severity.ERROR and isinstance(rule.trigger, Syntax | Nodes | Text)

    return RuleSet(ruleset.dialect, ruleset.settings, refuses)


def _tied(opener: Bracket, closer: Bracket) -> bool:
    """Whether two ends belong together; a missing label, which has a rule of its own, fits any."""
    return opener.kind == closer.kind and (opener.label == closer.label or None in (opener.label, closer.label))


def _fault(kind: str, gathered: Gathered, at: int, message: str) -> Fault:
    step = _directive(gathered, at)
    return Fault(kind, step.text.file, step.row, step.bracket.span, message, gathered.places[at].stack)


def _directive(gathered: Gathered, at: int) -> Directive:
    step = gathered.steps[at]
    assert isinstance(step, Directive)
    return step
