"""Where calls lead: to subprograms that are known, to files of their names, or further down (spec/rs274.md §6). Enters none."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.expand.rs274.files import loaded
from deburr.expand.rs274.unit import Unit
from deburr.fault import Fault, Halt
from deburr.host import sees_folder
from deburr.suggest import suggestion
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from deburr.expand.rs274.parts import Parts
    from deburr.expand.rs274.run import Run

Start = tuple[Unit, int]
"""Where a subprogram starts."""


class Targets:
    """The subprograms and numbered programs of one run."""

    def __init__(self, run: Run) -> None:
        self._run = run
        self._state = run.state
        self._units: dict[str, Unit | None] = {}
        self._known: dict[str, Start] = {}
        """What was passed or found, by label; whatever its file, the first counts."""

    def define(self, unit: Unit, row: int, parts: Parts) -> None:
        """A definition is met in the way."""
        label, state = parts.label(), self._state
        if state.calls:
            message = f"`{parts.said}` is met while a subprogram runs; definitions do not nest"
            raise state.fault("sub-nested", unit.file, row, parts.span, message)
        known = self._known.setdefault(label, (unit, row))
        if known != (unit, row):
            message = f"`{parts.said}` defines a subprogram a second time; the control refuses it"
            raise state.fault("sub-redefined", unit.file, row, parts.span, message)
        if row in unit.passed:
            message = f"`{parts.said}` is met when it is already known, by a call from above or in a second pass of a loop; the control stops here"
            raise state.fault("sub-before-definition", unit.file, row, parts.span, message)
        unit.passed.add(row)
        if (bare := unit.bare_in(row)) is not None:
            text = unit.document.line(bare).strip()
            message = f"`{text}` has no command: it starts a program, and the control comes by it in a subprogram"
            raise state.fault("sub-nested", unit.file, bare, Span(0, len(unit.document.line(bare).rstrip())), message)

    def found(self, label: str, unit: Unit, row: int, span: Span) -> Start:
        """The subprogram of a label: one that is known, that of a file of its name, or one further down in this file."""
        found = self._known.get(label)
        if found is None:
            found = self._in_file(label, unit, row, span)
            start = unit.sub_behind(label, row) if found is None else None
            if start is not None:
                found = unit, start
                self._run.reached.pass_to(unit, row, start)
            if found is None:
                near = suggestion(label, {*self._known, *unit.subs} - {label})
                raise self._missing(f"there is no subprogram `o<{label}>`", near, label, unit, row, span)
            self._know(label, *found)
        self._sound(*found)
        return found

    def numbered(self, label: str, unit: Unit, row: int, span: Span) -> Start:
        """The program that M98 means: one that is known, in a file of its number, or further down."""
        found = self._known.get(label)
        if found is None:
            target, above = self.load(label) or unit, row
            if target is not unit:
                above = -1
            starts = target.numbered_behind(label, above), target.sub_behind(label, above)
            start = min((at for at in starts if at is not None), default=None)
            if start is None:
                if target is unit:
                    raise self._missing(f"there is no program `O{label}`", "", label, unit, row, span)
                name = target.file.rpartition("/")[2]
                message = f"`{name}` has no program `O{label}`, and the control looks for it nowhere else"
                raise self._state.fault("sub-file", unit.file, row, span, message)
            self._pass_to(target, above, start)
            found = self._known[label] = target, start
        self._is_numbered(*found, f"M98 P{label}")
        return found

    def load(self, label: str) -> Unit | None:
        """The file of a label, read when it is first asked for."""
        if label not in self._units:
            unit = self._units[label] = loaded(self._run.job, label)
            if unit is not None:
                self._run.job.parts += (unit, unit.code)
        return self._units[label]

    def _know(self, label: str, unit: Unit, row: int) -> None:
        self._known[label] = unit, row
        unit.passed.add(row)

    def _in_file(self, label: str, unit: Unit, row: int, span: Span) -> Start | None:
        """The subprogram in the file of its name; None if there is no such file."""
        file = self.load(label)
        if file is None:
            return None
        start = file.sub_behind(label, -1)
        why = f"has no `o<{label}> sub`" if start is None else ""
        if file.is_framed and self._run.main.is_framed:
            why = "starts with `%`, as the program does, and nothing is found in it"
        if start is None or why:
            raise self._state.fault("sub-file", unit.file, row, span, f"the file `{file.file}` {why}")
        self._pass_to(file, -1, start)
        return file, start

    def _pass_to(self, unit: Unit, row: int, start: int) -> None:
        """Read on in a file to where a subprogram starts."""
        if unit is not self._run.main:
            self._run.reached.enter(unit)
        self._run.reached.pass_to(unit, row, start)

    def _missing(self, what: str, near: str, label: str, unit: Unit, row: int, span: Span) -> Halt:
        """The end of a run that finds no subprogram. Where no folder can be seen, its file was not given: that is no fault of the program."""
        job = self._run.job
        if sees_folder(job.host, job.programs[0].file):
            message = f"{what}, neither further down nor in a file `{label}.ngc`{near}"
            return self._state.fault("sub-unknown", unit.file, row, span, message)
        message = f"{what} further down, and no folder can be seen in which `{label}.ngc` might be{near}"
        return Halt(Fault("sub-unknown", unit.file, row, span, message, self._state.frame, input=True))

    def _is_numbered(self, unit: Unit, row: int, said: str) -> None:
        """Stop at a `sub` to which M98 leads."""
        if row in unit.ends:
            text = unit.document.line(row)
            message = f"`{said}` leads to a `sub`, which is only run by `call`; the control stops here"
            span = Span(len(text) - len(text.lstrip()), len(text.rstrip()))
            raise self._state.fault("sub-unknown", unit.file, row, span, message)

    def _sound(self, unit: Unit, row: int) -> None:
        """Stop where a subprogram in another file is wrong as it stands; the program itself has been checked before."""
        if unit is self._run.main or self._run.reached.active:
            return
        for at, finding in unit.errors(self._run.job).items():
            if row <= at <= unit.ends.get(row, row):
                place, kind = finding.place, finding.rule.partition(".")[2]
                span = Span(place.col, place.end_col)
                raise self._state.fault(kind, unit.file, at, span, finding.message)
