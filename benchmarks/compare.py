"""A program compared: what LinuxCNC's interpreter says of it, what deburr says, and whether the two agree. Never says who is right."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import NamedTuple

from benchmarks.interpreter import Answer, Program, answer
from deburr import source
from deburr.check import check
from deburr.finding import Finding, Place, Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name

DIALECT = by_name("rs274")
MACHINE = {"axes": "XYZABC"}
"""Settings of the machine that the stand-alone interpreter is."""


class Case(NamedTuple):
    """A program of the comparison. ``rule`` is what it was written for, "" for a fact about the interpreter."""

    kind: str
    name: str
    program: Program
    rule: str = ""


class Verdict(Enum):
    """What a comparison comes to."""

    AGREED = "agreed"
    ELSEWHERE = "elsewhere"
    SILENT = "silent"
    CLEAN = "clean"
    FALSE = "false"
    RUN = "needs a run"
    EXCLUDED = "excluded"


AT_END = {
    r"File ended with no percent sign": (
        "program-end-missing",
        "percent",
        "o-unclosed",
        "o-mismatch",
        "o-unopened",
        "break-target",
    ),
    r"EOF in file:.* from line: 0": ("sub-file", "sub-unknown"),
    r"Failed to find sub": ("sub-file", "sub-unknown", "o-unclosed"),
}
"""Refusals at the end of a file, which name no line, and the rules that tell why it was read to its end."""

_READS_VALUES = (
    "Attempt to divide by zero|Attempt to raise negative|Argument to|Negative argument|Zero or negative argument"
    "|Calculation resulted|Non integer value|Parameter number out of range|Cannot do g|Radius to end|Arc radius|Current point"
)
_OPENS = re.compile(r"(?im)^[ \t]*o[^\s]+[ \t]+(if|while|do|repeat)\b")
_CLOSES = re.compile(r"(?im)^[ \t]*o[^\s]+[ \t]+(?:endif|endwhile|endrepeat)\b")


def needs_run(said: Answer, program: Program) -> str | None:
    """Why only a run can tell that this is refused; None if the text tells. Each class is decided by what the interpreter says and the line it shows."""
    line = said.echo.lower()
    if said.endless:
        return "the program never ends"
    if "(abort" in line.replace(" ", ""):
        return "the program stops itself with `(ABORT,...)`"
    if re.match(r"Unknown m code used: M1\d\d$", said.message):
        return "M100 to M199 are files on the control"
    if said.message.startswith("Cannot restore context"):
        return "modes are brought back that the run has not kept"
    if re.match(_READS_VALUES, said.message) and "#" in line:
        return "the line reads a parameter, and its value is wrong"
    if said.message.startswith("Too many subroutine levels") and _in_branch(said, program):
        return "how deep calls go is decided in a branch"
    return None


def _in_branch(said: Answer, program: Program) -> bool:
    above = "\n".join(program.all_files[said.file or program.main].split("\n")[: said.line or 0])
    return len(_OPENS.findall(above)) > len(_CLOSES.findall(above))


@dataclass(frozen=True)
class Compared:
    """What both say of a program. ``rules`` are those of deburr that the verdict is about."""

    case: Case
    said: Answer
    findings: tuple[Finding, ...]
    excluded: str = ""

    @property
    def agrees(self) -> bool:
        """Whether nothing is to be explained: what is refused is found, what runs is clean."""
        return Compared(self.case, self.said, self.findings).verdict in (Verdict.AGREED, Verdict.CLEAN, Verdict.RUN)

    @cached_property
    def judged(self) -> tuple[Verdict, tuple[str, ...]]:
        """The verdict, and the rules of the errors that it rests on."""
        errors = tuple(dict.fromkeys(finding.rule.partition(".")[2] for finding in self.findings))
        if self.excluded:
            return Verdict.EXCLUDED, errors
        if self.said.ran:
            return (Verdict.FALSE if errors else Verdict.CLEAN), errors
        if agreeing := tuple(dict.fromkeys(self._agreeing())):
            return Verdict.AGREED, agreeing
        if self.reason:
            return Verdict.RUN, ()
        return (Verdict.ELSEWHERE if errors else Verdict.SILENT), errors

    @property
    def verdict(self) -> Verdict:
        """What the comparison comes to."""
        return self.judged[0]

    @cached_property
    def reason(self) -> str | None:
        """Why a run is needed to see that the program is refused."""
        return None if self.said.ran else needs_run(self.said, self.case.program)

    def _agreeing(self) -> Iterator[str]:
        at_end = next((rules for said, rules in AT_END.items() if re.match(said, self.said.message)), None)
        for finding in self.findings:
            rule = finding.rule.partition(".")[2]
            places = [finding.place, *(related.place for related in finding.related)]
            if rule in at_end if at_end is not None else any(map(self._is_refused_at, places)):
                yield rule

    def _is_refused_at(self, place: Place) -> bool:
        return (place.file, place.line) == (self.said.file, self.said.line)


class _Files:
    def __init__(self, files: Mapping[str, str]) -> None:
        self._files = files

    def read(self, path: str) -> str | None:
        return self._files.get(path)

    def names(self, folder: str) -> Sequence[str]:
        return sorted(self._files) if folder in ("", ".") else ()


def errors_of(program: Program) -> tuple[Finding, ...]:
    """All errors that deburr finds in the files of a program."""
    host = _Files(program.all_files)
    ruleset = RuleSet(DIALECT, MACHINE)
    found: list[Finding] = []
    for name, text in program.all_files.items():
        read = source.read(text.encode("utf-8"))
        if isinstance(read, source.NotAProgram):
            found.append(Finding("rs274.not-a-program", Severity.ERROR, read.reason, Place(name, 0, 0, 0, 0)))
        else:
            found += check(read, DIALECT, ruleset, name, host)
    return tuple(finding for finding in found if finding.severity is Severity.ERROR)


def compared(cases: Iterable[Case], excluded: Mapping[str, str]) -> list[Compared]:
    """Both said of every program; the interpreter in two processes at a time."""
    asked = list(cases)
    with ThreadPoolExecutor(2) as pool:
        answers = pool.map(answer, [case.program for case in asked])
        found = [errors_of(case.program) for case in asked]
        return [
            Compared(case, said, errors, excluded.get(case.name, "") if case.kind != "mended" else "")
            for case, said, errors in zip(asked, answers, found)
        ]
