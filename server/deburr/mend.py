"""All fixes of a program together, again and again until nothing is left that they could do. What would bring a finding is left out."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, NamedTuple

from deburr.fix import applied, fixes_of
from deburr_grammar.text import Pos

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Iterable, Iterator, Sequence

    from deburr.analysis import Analysis
    from deburr.finding import Finding, Fix
    from deburr_grammar.document import Document
    from deburr_grammar.text import Edit

ROUNDS = 50
"""More than a program needs: a line that is mended word by word has that many."""


class Mended(NamedTuple):
    """The program behind the fixes, and the findings that they took away."""

    document: Document
    fixed: tuple[Finding, ...]


class _Plan(NamedTuple):
    finding: Finding
    fix: Fix


def mended(document: Document, look: Callable[[Document], Analysis], *, unsafe: bool = False) -> Mended:
    """Fix what can be fixed; ``look`` says how a text of the program is read, ``unsafe`` whether guesses count."""
    work = mending(document, look, unsafe=unsafe)
    while True:
        try:
            next(work)
        except StopIteration as done:
            found: Mended = done.value
            return found


def mending(
    document: Document, look: Callable[[Document], Analysis], *, unsafe: bool = False
) -> Generator[None, None, Mended]:
    """The same as work that can be left at each of its steps."""
    fixed: list[Finding] = []
    for _ in range(ROUNDS):
        taken = yield from _round(document, look, unsafe)
        if not taken:
            break
        document = _behind(document, taken)
        fixed += [each.finding for each in taken]
    return Mended(document, tuple(fixed))


def _round(
    document: Document, look: Callable[[Document], Analysis], unsafe: bool
) -> Generator[None, None, list[_Plan]]:
    """The fixes that hold together; where all of them do not, half of them are tried, and so on."""
    with look(document) as analysis:
        findings = yield from analysis.gathering()
        plan = list(_apart(_plans(analysis, findings, unsafe)))
    best = Counter(each.rule for each in findings)
    taken: list[_Plan] = []
    waiting = [plan] if plan else []
    while waiting:
        part = waiting.pop()
        with look(_behind(document, [*taken, *part])) as analysis:
            left = yield from analysis.gathering()
        after = Counter(each.rule for each in left)
        if after.total() < best.total() and not after - best:
            taken, best = [*taken, *part], after
        elif len(part) > 1:
            half = len(part) // 2
            waiting += [part[half:], part[:half]]
    return taken


def _plans(analysis: Analysis, findings: Iterable[Finding], unsafe: bool) -> Iterator[_Plan]:
    for finding in findings:
        fix = next((each for each in fixes_of(analysis, finding) if each.safe or unsafe), None)
        if fix is not None:
            yield _Plan(finding, fix)


def _apart(plans: Iterable[_Plan]) -> Iterator[_Plan]:
    """Those of which no edit touches one of an earlier one; the others have their turn in the next round."""
    last = Pos(-1, 0)
    far: list[Edit] = []
    for plan in sorted(plans, key=lambda plan: min(plan.fix.edits)):
        edits = sorted(plan.fix.edits)
        touched = any(one.start <= two.end and two.start <= one.end for one in edits for two in far)
        if edits[0].start <= last or touched:
            continue
        # What stands further down than its own start is looked for; all else ends before the next one starts.
        far += edits[1:]
        last = max(last, edits[0].end)
        yield plan


def _behind(document: Document, plans: Sequence[_Plan]) -> Document:
    return applied(document, (edit for plan in plans for edit in plan.fix.edits))
