"""What the rules on a machine's reach say of the moves of a run, at the source lines that make them. Never runs a program."""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING

from deburr.fault import Entered
from deburr.finding import Finding, Related
from deburr.motion.follow import following
from deburr.motion.form import form_of
from deburr.motion.path import Recorder
from deburr.ran import SHOWN, Aside, all_of, around, line_of

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from deburr.analysis import Analysis
    from deburr.expand import SourceMap
    from deburr.rule import Report, Rule


def moved(
    analysis: Analysis,
    lines: Sequence[str],
    source_map: SourceMap,
    simulate: bool,
    aside: Callable[[Aside], None] | None = None,
) -> Iterator[Finding | None]:
    """The findings of a flat program's moves as work that can be left wherever it yields None.

    A source line is reported once by a rule, where it first breaks it. ``aside`` is told of what is not followed.
    """
    recorder = Recorder()
    yield from following(lines, recorder, form_of(analysis.ruleset, analysis.host, simulate))
    path = recorder.path()
    if aside is not None:
        for note in path.notes:
            origin = source_map.origin(note.flat)
            aside(Aside(origin.file, origin.row, note.text, "moves are not certain at"))
    for rule in analysis.ruleset.on_moves:
        seen = set[tuple[str, int]]()
        for report in rule.check(path, analysis.ruleset.machine):
            origin = source_map.origin(report.line)
            if (origin.file, origin.row) not in seen:
                seen.add((origin.file, origin.row))
                yield _finding(rule, report, analysis, source_map)


def _finding(rule: Rule, report: Report, analysis: Analysis, source_map: SourceMap) -> Finding:
    file, row, _ = source_map.origin(report.line)
    place = all_of(file, row, line_of(file, row, analysis))
    stack = tuple(_stack(source_map, report.line))
    return Finding(rule.name, analysis.ruleset.severity(rule), report.message, place, stack)


def _stack(source_map: SourceMap, flat: int) -> Iterator[Related]:
    for entry in islice(source_map.stack(flat), SHOWN):
        yield around(entry.file, entry.row, Entered(entry.kind), entry.number)
