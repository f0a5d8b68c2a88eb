"""`deburr check --fix` over LinuxCNC's own programs, whole and with small faults: what is safe leaves what the interpreter makes of them as it is, and done again does nothing more."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from deburr.cli.main import main
from support.flat import Case, ran
from support.oracle import SAMPLES
from support.samples import read, sample

pytestmark = pytest.mark.oracle
UNUSED = "(deburr: allow rs274.divide-by-zero)"
SPOILT: dict[str, Callable[[str], str]] = {
    "as they are": lambda text: text,
    "with a line that allows what is not there": lambda text: f"{UNUSED}\n{text}" if text[:1] != "%" else text,
}


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    folder = tmp_path / "ncfiles"
    shutil.copytree(SAMPLES, folder)
    return folder


def fixed(folder: Path, *options: str) -> None:
    main(["check", "--no-run", "-q", "-j", "1", "--output-format", "json", "--fix", *options, str(folder)])


def nothing_left(folder: Path, capsys: pytest.CaptureFixture[str], *options: str) -> bool:
    capsys.readouterr()
    code = main(["check", "--no-run", "-j", "1", "--diff", *options, str(folder)])
    said = capsys.readouterr()
    return (code, said.out, said.err) == (0, "", "Nothing to fix\n")


def programs() -> Sequence[Path]:
    found = sorted(path.relative_to(SAMPLES) for path in SAMPLES.rglob("*.ngc"))
    assert len(found) == 185
    return found


@pytest.mark.parametrize("how", SPOILT)
def test_safe_fixes_leave_what_programs_do(how: str, archive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    texts = {name: SPOILT[how](read(archive / name)) for name in programs()}
    for name, text in texts.items():
        (archive / name).write_text(text, encoding="utf-8", newline="")
    fixed(archive)
    assert nothing_left(archive, capsys)
    changed = [name for name, text in texts.items() if read(archive / name) != text]
    differ = []
    for name in changed:
        case: Case = sample(SAMPLES / name)
        before = ran({**case.all_files, case.main: texts[name]}, case.main)
        now = ran({**case.all_files, case.main: read(archive / name)}, case.main)
        if before.status == 0 and (now.status, now.calls) != (before.status, before.calls):
            differ.append((name, now.message))
    with capsys.disabled():
        print(f"\nfixes, {how}: {len(changed)} of {len(texts)} programs changed")
    assert differ == [] and len(changed) >= 3


def test_guesses_come_to_an_end(archive: Path, capsys: pytest.CaptureFixture[str]) -> None:
    fixed(archive, "--unsafe-fixes")
    assert nothing_left(archive, capsys, "--unsafe-fixes")
