"""Every target is fuzzed for some seconds, from the same seed each time; for minutes if DEBURR_FUZZ_MINUTES says so, from another seed each time.

Then what reaches new code is kept in the folder that DEBURR_FUZZ_CORPUS names.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from fuzz.targets import names
from support.code import ROOT

pytest.importorskip("atheris", reason="atheris, which fuzzes, is built for Linux on x86-64 alone")

MINUTES = float(os.environ.get("DEBURR_FUZZ_MINUTES", "0"))
"""Shared among the targets."""
RUNS = {"configuration": 1_500, "kept": 1_500, "tables": 20_000, "toolpaths": 10_000}
"""Inputs for targets that deal with one in less than a millisecond or two."""
SEEDS, MORE = 40, 80
MEGABYTES = 2_048
_SAID = re.compile(rb"(?m)^#[0-9]+\t(INITED|DONE) +cov: ([0-9]+) ft: ([0-9]+)")


def fuzzed(name: str, folder: Path, *options: str) -> subprocess.CompletedProcess[bytes]:
    """A fuzzer's run in a process of its own; libFuzzer ends it."""
    command = [sys.executable, "-m", "tests.fuzz", name, f"-artifact_prefix={folder}/{name}-", *options]
    return subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)


def limits(name: str, folder: Path) -> list[str]:
    if not MINUTES:
        return [f"--seeds={SEEDS}", f"-runs={RUNS.get(name, 2 * SEEDS + MORE)}", "-seed=1"]
    corpus = Path(os.environ.get("DEBURR_FUZZ_CORPUS", folder)) / name
    return [f"--corpus={corpus}", f"-max_total_time={round(MINUTES * 60 / len(names()))}"]


@pytest.mark.timeout(600 + 60 * MINUTES)
@pytest.mark.parametrize("name", names())
def test_nothing_is_found(name: str, tmp_path: Path) -> None:
    done = fuzzed(name, tmp_path, *limits(name, tmp_path), f"-rss_limit_mb={MEGABYTES}", "-timeout=120")
    assert done.returncode == 0, done.stdout[-6_000:].decode("utf-8", "replace")
    said = {match[1]: (int(match[2]), int(match[3])) for match in _SAID.finditer(done.stdout)}
    assert said[b"INITED"][0] > 100, "the code of deburr is not counted"
    assert said[b"DONE"] > said[b"INITED"], "no input has reached anything that the seeds do not"


@pytest.mark.parametrize(
    ("name", "runs", "said"), [("riddle", 400_000, b"solved"), ("edits", 4_000, b"of the edited document")]
)
def test_what_is_planted_is_found(name: str, runs: int, said: bytes, tmp_path: Path) -> None:
    """A riddle that takes the lead of coverage, and a parser that loses some edits."""
    done = fuzzed(f"fuzz.planted.{name}", tmp_path, f"--seeds={SEEDS}", f"-runs={runs}", "-seed=1")
    assert done.returncode != 0
    assert said in done.stdout
    assert [path.name.split("-")[1] for path in tmp_path.iterdir()] == ["crash"]
