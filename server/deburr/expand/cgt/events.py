"""What drives a template: the events of its toolpath, and data of the job that templates ask for (spec/cgt.md §5.8, §6, §11). Runs no section."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.expand.cgt.toolpath import Event, Toolpath
from deburr.fault import Fault, Halt
from deburr.formats import Fault as FormatFault
from deburr.formats.cl import statements
from deburr.templates.beside import Beside, beside, events_in, is_events
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.expand.job import Job
    from deburr.formats.cl import Statement
    from deburr.inputs import Ways
    from deburr.templates.template import Template

_NO_ELEMENTS = ("", "DECLARE", "START", "END", "TOOLCHG", "CYCLCHG")
_JOB = re.compile(r"jos(?:_str)?\(([^()]*)\)", re.I)


def is_job(name: str) -> bool:
    """Whether a name on the command line is job data, `JOS(tag)`."""
    return _JOB.fullmatch(name) is not None


def toolpath_of(job: Job) -> Beside:
    """The configured toolpath. Without one nothing can be output."""
    file = beside(job.settings, job.host, "input")
    template = job.programs[0].file
    if not file.path:
        way = job.inputs.ways.input
        message = f"a template is run by a toolpath, and none is given; name one with {way} (.cl or .jsonl), or as `input` under [cgt] in deburr.toml"
        if job.settings.get("input"):
            message = "a template is run by a toolpath, which text from standard input cannot have; put the template in a file"
        raise Halt(Fault("input-missing", template, 0, Span(0, 0), message, None, True))
    if file.text is None:
        raise Halt(Fault("cl-syntax", template, 0, Span(0, 0), f"the toolpath `{file.path}` cannot be read"))
    return file


class _Totals(NamedTuple):
    """How many elements a toolpath has, and how far each of its steps cuts; a step is what one tool does."""

    elements: int
    lengths: tuple[float, ...]


class JobData:
    """The toolpath of a run, and what else is known of its job."""

    def __init__(self, file: Beside, template: Template, ways: Ways) -> None:
        self._template = template
        self.ways = ways
        self._file = file
        self.path = self._file.path
        tags = ((_JOB.fullmatch(name), said) for name, said in template.given.items())
        self._tags = {match[1].strip().upper(): said for match, said in tags if match is not None}

    def events(self) -> Iterator[Event]:
        """The events in order, `START` and `END` among them."""
        if is_events(self._file):
            return self._listed()
        machine = self._template.machine
        path = Toolpath(machine.arc_center == "absolute", self._tool_in_start())
        return path.events(self._statements())

    def data(self, tag: str) -> str | None:
        """Job data, which only the user can give."""
        return self._tags.get(" ".join(tag.split()).upper())

    def elements(self) -> float | None:
        """How many elements the toolpath has."""
        return float(self._totals.elements)

    def length(self, step: float) -> float | None:
        """How far a step, counted from 1, cuts; None where nobody knows."""
        if is_events(self._file):
            return None
        number, lengths = round(step), self._totals.lengths
        return lengths[number] if 0 <= number < len(lengths) else 0.0

    @cached_property
    def _totals(self) -> _Totals:
        elements, lengths = 0, [0.0]
        for event in self.events():
            elements += event.element
            lengths[-1] += event.length
            if event.values and event.values[0][0] == "TOOL":
                lengths.append(0.0)
        return _Totals(elements, tuple(lengths))

    def _statements(self) -> Iterator[Statement | FormatFault]:
        for each in statements(self._file.text or ""):
            if isinstance(each, FormatFault) and not each.ignored:
                raise self._halt(each)
            yield each

    def _listed(self) -> Iterator[Event]:
        found = events_in(self._file)
        for fault in found.faults:
            raise self._halt(fault)
        sections = {event.section for event in found.events}
        if "START" not in sections:
            yield Event(0, "START")
        line = 0
        for line, section, _, given in found.events:
            values = tuple((each.name, each.value) for each in given)
            yield Event(line, section, values, section not in _NO_ELEMENTS)
        if "END" not in sections:
            yield Event(line, "END")

    def _tool_in_start(self) -> bool:
        """Whether the first tool is output by `@START`: as the machine file says, else if a line of `@START` itself holds the word."""
        said = self._template.machine.first_tool
        uses = self._template.uses
        return said == "start" or (
            not said and any(u.section.name == "START" and u.spelled.name == "TOOL" for u in uses)
        )

    def _halt(self, fault: FormatFault) -> Halt:
        return Halt(Fault("cl-syntax", self.path, fault.line, fault.span, fault.message))
