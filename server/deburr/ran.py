"""What a bounded run of a program meets, as findings. Never judges severity: the rule of a fault's name does."""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand import Budget, Inputs, Job, Kept, Program, SourceMap, drive, interpreter
from deburr.fault import Entered
from deburr.finding import Finding, Place, Related, Severity
from deburr.rule import Report

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from deburr.analysis import Analysis
    from deburr.fault import Fault, Frame
    from deburr.ruleset import RuleSet
    from deburr_grammar.dialect import Dialect

BLOCKS = 200_000
"""Executed blocks after which a run that only checks is left."""
SHOWN = 10
"""Calls and loops that a finding lists."""
_PASSED = "does not stop this run"
_SAID = {
    Entered.CALL: "called here",
    Entered.FILE: "read from here",
    Entered.LOOP: "in pass {} of the loop that starts here",
    Entered.SECTION: "run from here",
    Entered.JUMP: "reached by the jump here",
}


class Misgiven(Exception):
    """A value that was given for a run cannot be used: nothing was run, and no program is at fault."""


class Aside(NamedTuple):
    """What is to be said of a run though it is no finding: ``what`` is so at a line, and why."""

    file: str
    line: int
    why: str
    what: str = "run stopped at"


def ran(
    analysis: Analysis,
    inputs: Inputs | None = None,
    blocks: int = BLOCKS,
    aside: Callable[[Aside], None] | None = None,
) -> list[Finding]:
    """The findings of a run with these inputs, or else those of the analysis. What a machine, an operator or a missing input would decide ends it in silence, and so does the bound."""
    return [found for found in running(analysis, inputs, blocks, aside) if found is not None]


def running(
    analysis: Analysis,
    inputs: Inputs | None = None,
    blocks: int = BLOCKS,
    aside: Callable[[Aside], None] | None = None,
) -> Iterator[Finding | None]:
    """The same as work that can be left wherever it yields None; `Misgiven` if a value of the inputs is unusable. ``aside`` is told where it ended in silence, and what of its moves is not certain."""
    module = interpreter(analysis.dialect.name)
    inputs = inputs or analysis.inputs
    # Values that were given are judged even where no line reads one.
    moves = bool(analysis.ruleset.on_moves)
    if module is None or not (inputs.define or moves or module.worth_running(analysis.document)):
        return
    program = Program(analysis.file, analysis.document)
    kept, source_map = (Kept(), SourceMap()) if moves else (None, None)
    sink = kept or _Nowhere()
    job = Job((program,), analysis.ruleset, analysis.host, sink, inputs, Budget(blocks, 0), source_map)
    yield from drive(job)
    for fault in job.faults:
        if fault.given:
            raise Misgiven(fault.message)
    for fault in job.faults[:-1] if job.cut else job.faults:
        yield from _reported(fault, analysis)
    if kept is not None and source_map is not None:
        # Only a machine that is described pays for its moves.
        from deburr.moved import moved

        yield from moved(analysis, kept.lines, source_map, inputs.simulate, aside)
    if aside is not None and job.halted and (job.cut or _silent(job.faults[-1], analysis)):
        last = job.faults[-1]
        aside(Aside(last.file, last.line, last.message))


def worded(fault: Fault, ruleset: RuleSet, line: str) -> Finding:
    """A fault in the words of its rule. ``line`` is the text of the line at which it was met."""
    rule = ruleset.named(fault.kind)
    assert rule is not None, f"a run met `{fault.kind}`, of which there is no rule"
    report = next(iter(rule.met(fault))) if rule.met is not None else Report(fault.span, fault.message)
    start, end = report.span
    place = (
        Place(fault.file, fault.line, start, fault.line, end) if start != end else all_of(fault.file, fault.line, line)
    )
    related = tuple(_stack(fault.stack))
    if fault.passed:
        return Finding(rule.name, Severity.WARNING, f"{report.message} ({_PASSED})", place, related)
    return Finding(rule.name, ruleset.severity(rule), report.message, place, related)


def all_of(file: str, row: int, line: str) -> Place:
    """All of a line but the blanks around."""
    return Place(file, row, len(line) - len(line.lstrip()), row, max(len(line.rstrip()), 1))


def _reported(fault: Fault, analysis: Analysis) -> Iterator[Finding]:
    rule = analysis.ruleset.named(fault.kind)
    if rule in analysis.ruleset.rules and not _silent(fault, analysis):
        yield worded(fault, analysis.ruleset, line_of(fault.file, fault.line, analysis))


def _silent(fault: Fault, analysis: Analysis) -> bool:
    """Whether only what was not given decides there."""
    rule = analysis.ruleset.named(fault.kind)
    return fault.input or (rule is not None and rule.input)


def line_of(file: str, row: int, analysis: Analysis) -> str:
    """The text of a line of the program or of a file that it reads."""
    if file == analysis.file:
        return analysis.document.line(row)
    lines = (analysis.host.read(file) or "").split("\n")
    return lines[row] if row < len(lines) else ""


def _stack(stack: Frame | None) -> Iterator[Related]:
    """The calls, files and loop passes around a fault, innermost first."""
    for frame in islice(stack.outward(), SHOWN) if stack is not None else ():
        yield around(frame.file, frame.row, frame.kind, frame.number)


def around(file: str, row: int, kind: Entered, number: int) -> Related:
    """A call, file or loop pass as a related place."""
    return Related(Place(file, row, 0, row, 0), _SAID[kind].format(number), entered=True)


def before_a_run(found: Iterable[Finding], dialect: Dialect, inputs: Inputs, programs: int = 1) -> list[Finding]:
    """What a check found, as far as it speaks of a run of that many joined programs.

    Where a run finds every error by itself, what is wrong where it never runs is no error; what
    is wrong with one program alone may be right where they are joined; and a run that is only to
    be stopped by what it reaches tells of all errors itself.
    """
    module = interpreter(dialect.name)
    joined = programs > 1 and getattr(module, "CHECKS", False)
    if inputs.reached_only or joined or getattr(module, "ONLY_WHAT_RUNS", False):
        return [finding for finding in found if finding.severity < Severity.ERROR]
    return list(found)


def merged(found: Iterable[Finding], met: Iterable[Finding]) -> list[Finding]:
    """What a check warned of and a run then stops at is said once, as what it has become."""
    said = {(finding.rule, finding.place): finding for finding in found}
    for each in met:
        known = said.get((each.rule, each.place))
        if known is None or known.severity < each.severity:
            said[each.rule, each.place] = each
    return sorted(said.values(), key=lambda finding: finding.order)


class _Nowhere:
    """Lines that nobody wants."""

    def line(self, text: str) -> None:
        """Nothing."""

    def keep(self, count: int) -> None:
        """Nothing."""
