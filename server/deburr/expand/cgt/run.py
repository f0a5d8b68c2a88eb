"""A template run by its toolpath (spec/cgt.md §1, §6, §11): the loop that executes sections. Lines, words and sections have files of their own."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.expand.cgt.code import Compiler
from deburr.expand.cgt.events import JobData, is_job, toolpath_of
from deburr.expand.cgt.figures import format_of
from deburr.expand.cgt.pieces import Pieces
from deburr.expand.cgt.state import END, State, Unit
from deburr.expand.cgt.words import LONGEST, Words
from deburr.expand.held import errors, fault_of
from deburr.fault import Entered, Fault, Frame, Halt
from deburr.formats.machine import place
from deburr.templates.beside import beside, machine_in
from deburr.templates.template import Template, target, template_in
from deburr.templates.types import is_number
from deburr_grammar.dialects.cgt.outline import SECTIONS
from deburr_grammar.text import Span, split_lines

if TYPE_CHECKING:
    from deburr.expand.cgt.toolpath import Event
    from deburr.expand.cgt.words import Cell
    from deburr.expand.job import Job, Program
    from deburr.formats.machine import Machine
    from deburr.templates.items import Section
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode

_RUNS = frozenset(("WORD", "call", "repeat", "lookup", "block", "fmt", "EXITC"))
_QUIET = ("START", "END", "DECLARE", "CYCLCHG")
"""Sections that a template may lack: rules speak of the first two without a run."""


def run(job: Job) -> Iterator[None]:
    """Run the job's templates, each with the toolpath."""
    for program in job.programs:
        if job.inputs.reached_only:
            yield from hold(job, program)
        template = yield from template_in(program.document, _machine_of(job), job.inputs.define)
        yield from Run(job, program, template).all()


def worth_running(document: Document) -> bool:
    """Whether a run can find anything: a template without words, calls and loops outputs what it says."""
    for piece in document.pieces():
        for reading, _, shapes in piece.read():
            if reading.start is not None and any(not _RUNS.isdisjoint(s.facts(reading).kinds) for s in set(shapes)):
                return True
    return False


class Run:
    """One run of a template."""

    def __init__(self, job: Job, program: Program, template: Template) -> None:
        self._job = job
        self._file = program.file
        self._template = template
        if job.inputs.reached_only:
            self._sort_out()
        else:
            self._refuse_unknown()
        for section in self._template.sections if self._template.faulty_lines else ():
            if section.is_table:
                for row in section.rows:
                    self._refuse_faulty(row.line, row.line + 1)
        self._words = Words(self._template)
        # Before the toolpath is asked for: a value that was misgiven is wrong whatever is run.
        self._define()
        self._given = JobData(toolpath_of(job), self._template, job.inputs.ways)
        self._state = State(job, program.file, self._words, self._unit_of)
        job.where = self._state.where
        job.parts += (self, self._state)
        self._pieces = Pieces(self._state, self._template, self._given)
        self._units: dict[str, Unit | None] = {}
        self._called = {target(call)[0] for call, _ in self._template.calls()}
        self._cells: dict[str, Cell] = {}
        """The words that events set."""
        self._lost: set[str] = set()

    def all(self) -> Iterator[None]:
        """Every section that the generator runs, in slices of executed lines."""
        state = self._state
        for unit, frame in self._sections():
            at = state.start(unit, frame, unit.name == "DECLARE") if unit is not None else END
            while at >= 0 or (unit is None and state.left <= 0):
                if state.left <= 0:
                    row = state.unit.rows[at] if at >= 0 else 0
                    state.left += self._job.slice(self._file, row, state.lines.frame)
                    yield
                while state.left > 0 and at >= 0:
                    at = state.unit.ops[at]()
        state.lines.finish()
        self._job.steps -= state.left

    def _sections(self) -> Iterator[tuple[Unit | None, Frame | None]]:
        """The sections in order, each when the words of its event are set; None for an event that runs none."""
        if (declares := self._unit_of("DECLARE")) is not None:
            yield declares, None
        cells, path = self._cells, self._given.path
        for event in self._given.events():
            self._state.left -= 1
            for name, value in event.values:
                (cells.get(name) or self._cell(name, event)).set(value)
            unit = self._unit_of(event.section) if event.section else None
            if unit is None:
                self._lose(event)
                yield None, None
                continue
            frame = Frame(None, path, event.line, Entered.SECTION, 0)
            change = self._unit_of("CYCLCHG") if event.section in SECTIONS - {"DECLARE", "CYCLCHG"} else None
            if change is not None:
                yield change, frame
            yield unit, frame

    def _cell(self, name: str, event: Event) -> Cell:
        cell = self._words.find(name)
        if cell is None:
            message = f"there is no word `{name}` to set"
            raise Halt(Fault("cl-syntax", self._given.path, event.line, Span(0, 0), message))
        self._cells[name] = cell
        return cell

    def _lose(self, event: Event) -> None:
        """Say once that a sort of event has no section."""
        name = event.section
        if name and name not in _QUIET and name not in self._lost:
            self._lost.add(name)
            message = f"the template has no section `@{name}`, so this and all others of its sort are lost"
            self._job.meet(Fault("event-lost", self._given.path, event.line, Span(0, 0), message))

    def _unit_of(self, name: str) -> Unit | None:
        """A section as operations, compiled when it is first run."""
        if name not in self._units:
            section = self._template.by_name.get(name)
            self._units[name] = self._compiled(section) if section is not None else None
        return self._units[name]

    def _compiled(self, section: Section) -> Unit:
        if self._job.inputs.reached_only:
            return self._compiler(section).reached(self._rows(section))
        if self._template.faulty_lines:
            rows = self._rows(section)
            self._refuse_faulty(rows.start, rows.stop)
        return self._compiler(section).unit()

    def _compiler(self, section: Section) -> Compiler:
        return Compiler(self._state, self._pieces, section, section.name in self._called)

    def _rows(self, section: Section) -> range:
        """The lines of a section, its header first."""
        behind = (each.line for each in self._template.sections if each.line > section.line)
        return range(section.line, next(behind, self._template.lines[-1][0] + 1))

    def _sort_out(self) -> None:
        """Hold what nobody can read, and stop at what is read before a section runs: declarations, tables, and what stands in no section."""
        job, file = self._job, self._file
        known = frozenset(job.held.in_file(file))
        for line, node in self._template.lines:
            if node.problems and line not in known:
                job.held.hold(self._unread(line, node))
        for fault in self._unknown():
            job.held.hold(fault)
        late = {row for each in self._template.sections if _runs(each) for row in self._rows(each)}
        for line in sorted(job.held.in_file(file)):
            if line not in late:
                job.held.come(job, file, line, None)

    def _unread(self, line: int, node: LineNode) -> Fault:
        problem = node.problems[0]
        message = f"`{node.text[problem.start : problem.end]}` cannot be read here"
        return Fault(problem.kind, self._file, line, Span(problem.start, problem.end), message)

    def _refuse_faulty(self, first: int, behind: int) -> None:
        """Lines that cannot be read are met only where the rule that would have said so is off."""
        for line, node in self._template.lines:
            if first <= line < behind and node.problems:
                raise Halt(self._unread(line, node))

    def _refuse_unknown(self) -> None:
        """What a word that nobody knows prints is not known, wherever it stands."""
        for fault in self._unknown():
            raise Halt(fault)

    def _unknown(self) -> Iterator[Fault]:
        for use in self._template.uses:
            if use.spelled.kind == "unknown" and use.role not in ("macro", "declared"):
                given = self._job.inputs.ways.define.format(f"{use.said}=VALUE")
                message = f"`#{use.said}` is no known word, so the template cannot be expanded; a machine file's `[words]` or {given} makes it known"
                yield Fault("word-unknown", self._file, use.line, use.span, message, None, True)

    def _define(self) -> None:
        """Values for this run by the words' names."""
        for name, said in self._template.given.items():
            if is_job(name):
                continue
            cell, given, unusable = self._words.find(name), f"{name}={said}", self._job.unusable
            if cell is None or not (cell.settable or cell.type == "text"):
                raise unusable("eval-target", given, f"`#{name}` cannot be set")
            if len(split_lines(said)) > 1:
                raise unusable("eval-type", f"{name}=...", "the value holds a line break")
            if cell.is_text:
                if cell.type == "string" and len(said) > LONGEST:
                    raise unusable("string-length", f"{name}=...", f"a word holds {LONGEST} characters")
                cell.set(said)
            elif is_number(said):
                cell.set(float(said))
            else:
                raise unusable("eval-type", given, f"`#{name}` takes a number")


def _runs(section: Section) -> bool:
    """Whether a section is read when it runs, and not before."""
    return not section.is_table and not section.faulty and section.name != "DECLARE"


def hold(job: Job, program: Program) -> Iterator[None]:
    """Hold what a check calls wrong in a template."""
    for finding in (yield from errors(job, program.file, program.document)):
        job.held.hold(fault_of(finding))


def _machine_of(job: Job) -> Machine:
    """The machine file, with formats that numbers can have."""
    file = beside(job.settings, job.host, "machine")
    machine = machine_in(file)
    for name, said in machine.formats.items():
        if format_of(said) is None:
            message = f"`{said}` is no format that a number can have"
            raise Halt(Fault("machine-file", file.path, *place(file.text or "", ("formats", name)), message))
    return machine
