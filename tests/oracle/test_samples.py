"""LinuxCNC's own sample programs: what runs there has no error here."""

import json
from pathlib import Path

import pytest

from deburr.cli.main import main
from support.oracle import SAMPLES

BROKEN_AS_SHIPPED = {("nestedcall.ngc", 11, "rs274.o-unknown")}
"""`O<g20sub> callsub`: the interpreter stops at it, too (spec/corpus.md §2)."""


@pytest.mark.oracle
def test_no_error_on_the_sample_programs(capsys: pytest.CaptureFixture[str]) -> None:
    programs = sorted(SAMPLES.rglob("*.ngc"))
    assert len(programs) == 185
    assert main(["check", "--no-cache", "--no-run", "--output-format", "json", "-j", "1", *map(str, programs)]) == 1
    findings = json.loads(capsys.readouterr().out)
    errors = {
        (Path(finding["filename"]).name, finding["location"]["row"], finding["rule"])
        for finding in findings
        if finding["severity"] == "error"
    }
    assert errors == BROKEN_AS_SHIPPED
