"""The benchmarks at a tiny size: they work, their programs are clean, and a keystroke's work does not grow with the file."""

from __future__ import annotations

from collections.abc import Iterator
from unittest import mock

import pytest
from benchmarks import corpus, ours, rows, theirs
from benchmarks.__main__ import main
from benchmarks.macros import macros

from deburr.analysis import Analysis
from deburr.finding import Severity
from deburr.modal import Modal
from deburr.ruleset import RuleSet
from deburr.values import proving
from deburr_grammar import line as line_module
from deburr_grammar.chunk import SIZE
from deburr_grammar.dialects import NAMES, by_name
from deburr_grammar.document import Document
from support.oracle import Verdict, judged

QUICK = ["--quick", "--only"]


@pytest.mark.parametrize("make", [corpus.cam, corpus.macro, corpus.mixed])
def test_corpora_are_clean_and_of_the_length_asked_for(make) -> None:
    text = make(3_000)
    assert text.count("\n") == 3_000 and text == make(3_000)
    assert Analysis(Document.parse(text, ours.DIALECT), RuleSet(ours.DIALECT), prove=proving).findings() == []


@pytest.mark.oracle
def test_the_interpreter_runs_the_macros_to_their_end(tmp_path) -> None:
    assert judged(corpus.macro(3_000), tmp_path) == Verdict(True, "", "")


@pytest.mark.oracle
def test_only_a_run_to_the_end_is_measured(tmp_path, monkeypatch) -> None:
    program = tmp_path / "a.ngc"
    program.write_text("G21\nM2\n")
    assert (theirs.interpreter(str(program)) or 0) > 0
    program.write_text("G21\nG0 X[1/0]\nM2\n")
    with pytest.raises(theirs.Unfinished, match=r"ended with 1: "):
        theirs.interpreter(str(program))
    # One that says all is well, and was cut short.
    short = tmp_path / "rs274"
    short.write_text("#!/bin/sh\necho '    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)'\n")
    short.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    with pytest.raises(theirs.Unfinished, match=r"ended with 0: .*USE_LENGTH_UNITS"):
        theirs.interpreter(str(program))


def test_the_cam_program_is_numbered_motion_for_the_most_part() -> None:
    lines = corpus.cam(20_000).split("\n")
    assert 0.96 < sum(line.startswith("N") for line in lines) / len(lines) < 0.985


@pytest.mark.parametrize("name", NAMES)
def test_what_is_proven_of_is_right(name: str) -> None:
    """No error, or the program would not be one that anybody runs."""
    dialect = by_name(name)
    analysis = Analysis(Document.parse(macros(name, 400), dialect), RuleSet(dialect), prove=proving)
    assert [finding for finding in analysis.findings() if finding.severity is Severity.ERROR] == []


def test_the_macros_are_of_many_shapes() -> None:
    folded = ours.DIALECT.folding.fold(corpus.macro(20_000))
    assert len(set(folded.split("\n"))) > 2_000


@pytest.mark.parametrize("title", ["typing", "starting", "expanding", "editor", "proven values"])
def test_report(title: str, tmp_path, capsys: pytest.CaptureFixture[str]) -> None:
    report = tmp_path / "performance.md"
    assert main([*QUICK, title, "--write", str(report)]) == 0
    written = report.read_text(encoding="utf-8")
    assert written.startswith("# Performance") and "Machine: " in written
    assert capsys.readouterr().out.strip() in written


class Work:
    """Counts what a keystroke costs: lines parsed by Lark, lines folded to shapes, lines that the modal fold goes through."""

    def __init__(self) -> None:
        self.parsed = self.folded = self.stepped = 0

    def counted(self) -> Iterator[None]:
        parse, fold, plain = ours.DIALECT.grammar.parse, type(ours.DIALECT.folding).fold, Modal.plain

        def parsing(start, text):
            self.parsed += 1
            return parse(start, text)

        def folding(each, text):
            self.folded += text.count("\n") + 1
            return fold(each, text)

        def stepping(each, *arguments):
            self.stepped += 1
            return plain(each, *arguments)

        with (
            mock.patch.object(ours.DIALECT.grammar, "parse", parsing),
            mock.patch.object(type(ours.DIALECT.folding), "fold", folding),
            mock.patch.object(Modal, "plain", stepping),
        ):
            yield


def work_of(lines: int, stroke: ours.Keystroke, at: float) -> Work:
    document, ruleset = Document.parse(corpus.cam(lines), ours.DIALECT), ours.ready()
    ours.warm(document, ruleset)
    work = Work()
    for _ in work.counted():
        ours.answer(document, ours.typed(document, int(document.line_count * at), stroke), ruleset)
    return work


@pytest.mark.parametrize("stroke", ours.KEYSTROKES, ids=lambda stroke: stroke.name)
@pytest.mark.parametrize("at", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("lines", [1_000, 20_000])
def test_a_keystroke_reads_the_lines_it_touches_and_folds_through_one_chunk(stroke, at: float, lines: int) -> None:
    line_module._parse.cache_clear()
    work = work_of(lines, stroke, at)
    longest = 2 * SIZE // 8
    assert work.folded <= 3 and work.parsed <= 3
    assert work.stepped <= longest


def test_the_odd_programs_are_answered(tmp_path) -> None:
    sizes = rows.Sizes(cam=500, macro=500, mixed=500, odd=3_000, places=20)
    files = rows.Files.written(tmp_path, sizes)
    for path in (files.mixed, *files.odd.values()):
        _, found = ours.everything(path)
        assert found == 0 or path != files.mixed
        assert ours.keystrokes(path, 1)
