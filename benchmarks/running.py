"""What is measured of expansion. Each function runs in a process of its own."""

from __future__ import annotations

from tempfile import TemporaryFile
from typing import IO

from benchmarks.measure import growth, seconds
from benchmarks.ours import DIALECT, read, ready
from deburr.expand import Budget, Job, Program, SourceMap, drive
from deburr.host import NoFiles
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr_grammar.document import Document


class _File:
    """Lines into a file."""

    def __init__(self, out: IO[bytes]) -> None:
        self._write = out.write

    def line(self, text: str) -> None:
        """One line."""
        self._write(text.encode() + b"\n")

    def keep(self, count: int) -> None:
        """No line of what is measured is taken back."""
        raise AssertionError(count)


def expand(path: str) -> float:
    """Seconds from the text to a flat file, without a map."""
    text, ruleset = read(path), ready()
    return seconds(lambda: _run(Document.parse(text, DIALECT), ruleset, None))


def memory(path: str, mapped: bool) -> int:
    """Bytes beyond the text while a program is expanded into a file."""
    document, ruleset = Document.parse(read(path), DIALECT), ready()
    return growth(lambda: _run(document, ruleset, SourceMap() if mapped else None))


def _run(document: Document, ruleset: RuleSet, source_map: SourceMap | None) -> SourceMap | None:
    with TemporaryFile() as out:
        program = Program("p.ngc", document)
        # What the interpreter takes for the machine's values when it runs alone.
        job = Job((program,), ruleset, NoFiles(), _File(out), Inputs(simulate=True), Budget(0, 0), source_map)
        for _ in drive(job):
            pass
        assert not job.faults, job.faults
    return source_map
