"""A program and its expansion through LinuxCNC's interpreter: are the canonical calls the same (spec/oracle.md §3)? Never judges who is right."""

import os
import re
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory

from deburr.analysis import Analysis
from deburr.expand import Budget, Expansion, Inputs, Program, expand
from deburr.expand.job import EXACT
from deburr.fault import Fault
from deburr.finding import Severity
from deburr.ruleset import RuleSet
from deburr_grammar.dialects import by_name
from deburr_grammar.document import Document
from support.pages import MemoryHost

DIALECT = by_name("rs274")
MAIN, TABLE, STORED = "main.ngc", "tools.tbl", "p.var"
RULES = RuleSet(DIALECT, {"axes": "XYZABC", "tool-table": TABLE, "parameters": STORED})
"""The settings under which deburr is the machine that the stand-alone interpreter is."""
INPUTS = Inputs(simulate=True, decimals=EXACT, block_delete=False)
TOOLS = (
    "".join(f"T{number} P{number} D0.001\n" for number in range(3, 100))
    + "T1 P1 Z1.5 D0.25\nT2 P2 X0.5 Z-0.25 D0.5 I1 J2 Q3\n"
)
SECONDS = 4
_MEMORY = Path("/dev/shm")
"""The interpreter waits for a disk each time that it writes its parameters."""
_CALL = re.compile(r" *\d+ N[0-9.]+ +(.*)")
_MINUS_ZERO = re.compile(r"-(0\.0+)(?![0-9])")
_TAG = re.compile(r"^N(\d+)|;(\d+)\s*$", re.I)
_SEEKING = re.compile(r"EOF in file:.* seeking o-word: .* from line: ([1-9][0-9]*)$")
_MESSAGE = re.compile(r"^\d+: ")
Place = tuple[str, int]


@dataclass(frozen=True)
class Ran:
    """What the interpreter made of a program: its canonical calls, its messages, what it said of a fault and the line that it then showed."""

    status: int | None
    calls: tuple[str, ...] = ()
    message: str = ""
    echo: str = ""

    @property
    def tagged(self) -> int | None:
        """The row of the fault, if lines carry their numbers (1-based) as N words or behind a `;`."""
        tag = _SEEKING.match(self.message) or _TAG.search(self.echo.strip())
        return int(tag[tag.lastindex or 0]) - 1 if tag is not None else None


@dataclass(frozen=True)
class Case:
    """A program with the files beside it."""

    name: str
    text: str
    files: Mapping[str, str] = field(default_factory=dict)
    main: str = MAIN
    tools: str = TOOLS
    checked: bool = True
    """Whether it is also checked before it is run."""
    reached: bool = False
    """Whether only what the run reaches may stop it: then a check of it decides nothing."""
    tagged: bool = False
    """Whether its lines carry their numbers: see `Ran.tagged`."""

    @cached_property
    def all_files(self) -> dict[str, str]:
        """What stands in the program's folder."""
        return {TABLE: self.tools, STORED: "", **self.files, self.main: self.text}

    @cached_property
    def document(self) -> Document:
        """The program as it is read."""
        return Document.parse(self.text, DIALECT)

    @cached_property
    def host(self) -> MemoryHost:
        """Its files."""
        return MemoryHost(self.all_files)

    @cached_property
    def original(self) -> "Ran":
        """What the interpreter makes of it."""
        return ran(self.all_files, self.main)

    @cached_property
    def wrong(self) -> frozenset[Place]:
        """Where a check finds errors, without a run."""
        if self.reached or not self.checked:
            return frozenset()
        found = Analysis(self.document, RULES, self.main, self.host).findings()
        return frozenset((each.place.file, each.place.line) for each in found if each.severity is Severity.ERROR)

    @cached_property
    def expansion(self) -> Expansion:
        """Its expansion, whatever a check says of it."""
        inputs = INPUTS._replace(reached_only=self.reached)
        return expand([Program(self.main, self.document)], RULES, self.host, inputs, Budget(200_000, 200_000))

    @cached_property
    def refused(self) -> frozenset[Place]:
        """Where deburr refuses it: before a run, or at the line that a run cannot pass. Empty: it is expanded."""
        return self.wrong or self.stopped

    @cached_property
    def stopped(self) -> frozenset[Place]:
        """The line that a run cannot pass."""
        return frozenset((fault.file, fault.line) for fault in self.errors)

    @cached_property
    def errors(self) -> tuple[Fault, ...]:
        """What ends its run."""
        return tuple(fault for fault in self.expansion.faults if not fault.passed and is_error(fault.kind))

    @property
    def flat(self) -> str:
        """The expansion as a program."""
        return "".join(f"{line}\n" for line in self.expansion.lines)


def is_error(kind: str) -> bool:
    """Whether a fault of a run ends it."""
    rule = RULES.named(kind)
    assert rule is not None, f"there is no rule `{kind}`"
    return RULES.severity(rule) is Severity.ERROR


def ran(files: Mapping[str, str], main: str = MAIN) -> Ran:
    """Run a program of a folder with these files, with a home of its own."""
    with TemporaryDirectory(dir=_MEMORY if _MEMORY.is_dir() else None) as name:
        folder = Path(name)
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(text.encode("utf-8"))
        limits = f"ulimit -t {SECONDS}; ulimit -f 100000"
        command = ["sh", "-c", f"{limits}; exec rs274 -g -n 2 -t {TABLE} -v {STORED} {main} >out 2>err"]
        # It has Python in it, which need not look for packages.
        environment = {**os.environ, "HOME": name, "PYTHONNOUSERSITE": "1"}
        nothing = subprocess.DEVNULL
        try:
            done = subprocess.run(command, cwd=folder, env=environment, stdin=nothing, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return Ran(None)
        out, err = ((folder / one).read_bytes().decode("utf-8", "replace") for one in ("out", "err"))
    said = [line for line in err.split("\n") if line and line != "executing"]
    message, echo, *_ = [*said, "", ""]
    status = done.returncode if done.returncode in (0, 1) else None
    return Ran(status, canonical(out), _MESSAGE.sub("", message), echo)


def canonical(output: str) -> tuple[str, ...]:
    """The calls of a run as they are compared: without numbers in front, comments, and signs of zeros."""
    found = []
    for line in output.split("\n"):
        call = _CALL.fullmatch(line)
        text = call[1] if call is not None else line
        if text and not (text.startswith("COMMENT(") and "interpreter:" not in text):
            found.append(_MINUS_ZERO.sub(r"\1", text))
    return tuple(found)


def difference(case: Case) -> str:
    """How the runs of a program that is accepted and of its expansion differ; nothing if they do not."""
    original = case.original
    flat = ran({TABLE: case.tools, STORED: case.all_files[STORED], MAIN: case.flat})
    if flat.calls == original.calls and flat.status == original.status:
        return ""
    pairs = zip([*original.calls, "(end)"], [*flat.calls, "(end)"])
    first = next(((at, one, two) for at, (one, two) in enumerate(pairs) if one != two), None)
    return f"first difference {first}; {flat.message} {flat.echo}"


def verdict(case: Case) -> str:
    """Nothing if deburr and the interpreter agree on a program; else how they differ."""
    original = case.original
    if original.status is None:
        return "" if case.refused else "endless there, expanded here"
    if original.status == 0:
        return f"refused here: {case.refused} {_said(case)}" if case.refused else difference(case)
    if not case.refused:
        return f"refused there: {original.message} at {original.echo!r}"
    row, places = original.tagged if case.tagged else None, case.wrong | case.stopped
    if row is not None and (case.main, row) not in places and not any(file != case.main for file, _ in places):
        return f"refused there in line {row + 1}: {original.message}; here {sorted(case.refused)} {_said(case)}"
    return ""


def _said(case: Case) -> list[str]:
    return (
        [] if case.wrong else [f"{fault.kind}: {fault.message}" for fault in case.expansion.faults if not fault.passed]
    )
