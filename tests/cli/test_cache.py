"""What earlier checks found is found again without work, as long as nothing that decided it has changed."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

MAIN = "G21 G90 G17\nF100\no<shared> call [{}]\nM2\n"
SHARED = "o<shared> sub\nG0 X[1/[#1-3]]\no<shared> endsub\nM2\n"
NAMES = ("a.ngc", "b.ngc", "c.ngc", "shared.ngc")


def read_anew(shell, *more: str) -> list[str]:
    """The programs that a check works on."""
    lines = shell.run("check", "-v", *more).err.splitlines()
    files = [line.split(": ")[1] for line in lines if "run stopped" not in line]
    return [file for file, line in zip(files, lines) if not line.endswith("known from an earlier check")]


@pytest.fixture
def archive(shell, monkeypatch):
    monkeypatch.delenv("DEBURR_CACHE_DIR")
    for number, name in enumerate("ab"):
        shell.write(f"{name}.ngc", MAIN.format(number + 2))
    shell.write("c.ngc", "G21 G90 G17\nG0 X1 (a (b) c)\nF100\nM2\n")
    shell.write("shared.ngc", SHARED)
    shell.cold = shell.run("check")
    assert shell.cold.code == 1 and shell.cold.out.count("error[") == 2
    return shell


def entries(shell) -> list[Path]:
    return [path for path in (shell.folder / ".deburr_cache").rglob("*") if len(path.parent.name) == 2]


@pytest.mark.parametrize("form", ["full", "concise", "json", "sarif", "gitlab", "junit"])
def test_a_second_check_says_the_same_and_reads_nothing_anew(archive, form):
    fresh = archive.run("check", "--output-format", form, "--no-cache")
    assert archive.run("check", "--output-format", form) == fresh
    assert read_anew(archive) == []
    assert archive.run("check") == archive.cold


def test_where_a_run_stopped_is_known_too(archive):
    archive.write("d.ngc", "#1=1\nG0 X#5061\nM2\n")
    stopped = [line for line in archive.run("check", "-v").err.splitlines() if "run stopped" in line]
    assert stopped == [line for line in archive.run("check", "-v").err.splitlines() if "run stopped" in line] != []


def test_a_change_is_read_and_nothing_else(archive):
    archive.write("c.ngc", "G21 G90 G17\nG0 X1\nF100\nM2\n")
    assert read_anew(archive) == ["c.ngc"]
    assert archive.run("check") == archive.run("check", "--no-cache")


def test_what_hangs_on_a_changed_file_is_read_again(archive):
    archive.write("shared.ngc", SHARED.replace("#1-3", "#1-2"))
    assert read_anew(archive) == ["a.ngc", "b.ngc", "shared.ngc"]
    again = archive.run("check")
    assert again == archive.run("check", "--no-cache") and "a.ngc:3:1" in again.out


def test_a_file_that_goes_or_comes_back_counts(archive):
    (archive.folder / "shared.ngc").rename(archive.folder / "gone.txt")
    assert archive.run("check") == archive.run("check", "--no-cache") != archive.cold
    (archive.folder / "gone.txt").rename(archive.folder / "shared.ngc")
    assert archive.run("check") == archive.cold


def test_going_back_costs_nothing(archive):
    before = (archive.folder / "c.ngc").read_text()
    archive.write("c.ngc", "G21\nM2\n")
    archive.run("check")
    archive.write("c.ngc", before)
    assert read_anew(archive) == [] and archive.run("check") == archive.cold


@pytest.mark.parametrize(
    "options",
    [
        ["--ignore", "rs274.comment-nested"],
        ["--no-run"],
        ["--profile", "smithy"],
        ["--dialect", "rs274"],
        ["--block-delete", "on"],
        ["-D", "7=1"],
    ],
)
def test_other_options_are_another_check(archive, options):
    assert read_anew(archive, *options) == list(NAMES)
    assert archive.run("check", *options) == archive.run("check", *options, "--no-cache")
    assert read_anew(archive, *options) == []
    assert read_anew(archive) == []


def test_another_configuration_is_another_check(archive):
    archive.write("deburr.toml", '[check]\nignore = ["rs274.comment-nested"]\n')
    assert read_anew(archive) == list(NAMES)
    archive.write("deburr.toml", '[check]\nfail-on = "info"\n[check.per-file-ignores]\n"c.ngc" = ["rs274"]\n')
    assert archive.run("check") == archive.run("check", "--no-cache")
    archive.write("part.vars", "7=1\n")
    assert read_anew(archive, "--variables", "part.vars") == list(NAMES)
    archive.write("part.vars", "7=2\n")
    assert read_anew(archive, "--variables", "part.vars") == list(NAMES)


def test_another_deburr_is_another_check(archive, monkeypatch):
    monkeypatch.setattr("deburr.cli.kept.build", lambda: "another")
    assert read_anew(archive) == list(NAMES)


def test_a_configured_file_that_goes_is_said(archive):
    archive.write("tools.tbl", "T1 P1 D1\n")
    archive.write("deburr.toml", '[rs274]\ntool-table = "tools.tbl"\n')
    assert archive.run("check").code == 1
    (archive.folder / "tools.tbl").unlink()
    ran = archive.run("check")
    assert ran.code == 2 and "tools.tbl" in ran.err


DAMAGE = {
    "cut short": lambda data: data[: len(data) // 2],
    "empty": lambda data: b"",
    "one byte of the findings": lambda data: data[:-20] + bytes([data[-20] ^ 1]) + data[-19:],
    "no text": lambda data: os.urandom(len(data)),
    "of another program": None,
    "deep": lambda data: b"[" * 100_000,
}


@pytest.mark.parametrize("how", DAMAGE)
def test_what_is_damaged_is_none(archive, how):
    found = entries(archive)
    assert len(found) == 4
    whole = [path.read_bytes() for path in found]
    for path, data, other in zip(found, whole, whole[1:] + whole[:1]):
        path.write_bytes(other if DAMAGE[how] is None else DAMAGE[how](data))
    assert read_anew(archive) == list(NAMES)
    assert read_anew(archive) == []
    assert archive.run("check") == archive.cold


def test_an_entry_that_cannot_be_written_is_left(archive):
    for path in entries(archive):
        path.unlink()
        path.mkdir()
    assert archive.run("check") == archive.cold


def test_the_folder_is_out_of_the_way(archive, monkeypatch):
    place = archive.folder / ".deburr_cache"
    assert (place / ".gitignore").read_text() == "*\n"
    assert (place / "CACHEDIR.TAG").read_text().startswith("Signature: 8a477f597d28d172789f06886806bc55")
    archive.write(".deburr_cache/x.ngc", MAIN)
    assert archive.run("check") == archive.cold
    (archive.folder / "sub").mkdir()
    archive.write("deburr.toml", "")
    monkeypatch.chdir(archive.folder / "sub")
    assert archive.run("check", "..").code == 1
    assert not (archive.folder / "sub/.deburr_cache").exists()


def test_it_lies_where_it_is_wanted(archive, monkeypatch, tmp_path_factory):
    place = tmp_path_factory.mktemp("elsewhere") / "kept"
    monkeypatch.setenv("DEBURR_CACHE_DIR", str(place))
    assert read_anew(archive) == list(NAMES) and (place / ".gitignore").exists()
    assert read_anew(archive) == []


@pytest.mark.parametrize("arguments", [["--no-cache"], ["--diff"], ["a.ngc"]])
def test_nothing_is_kept(shell, monkeypatch, arguments):
    monkeypatch.delenv("DEBURR_CACHE_DIR")
    for name in "ab":
        shell.write(f"{name}.ngc", "G21\nM2\n")
    shell.run("check", *arguments)
    assert not (shell.folder / ".deburr_cache").exists()


def test_a_link_is_not_followed_and_a_file_is_no_place(shell, monkeypatch):
    monkeypatch.delenv("DEBURR_CACHE_DIR")
    for name in "ab":
        shell.write(f"{name}.ngc", "G21\nM2\n")
    (shell.folder / "else").mkdir()
    (shell.folder / ".deburr_cache").symlink_to("else")
    assert shell.run("check").code == 0 and list((shell.folder / "else").iterdir()) == []
    (shell.folder / ".deburr_cache").unlink()
    shell.write(".deburr_cache", "")
    assert shell.run("check") == (0, "All checks passed (2 checked)\n", "")


def test_what_is_old_is_taken_away(archive):
    place = archive.folder / ".deburr_cache"
    old, *rest = entries(archive)
    half, young = place / "00" / ".x.0.deburr-part", place / "00" / ".y.1.deburr-part"
    half.parent.mkdir(exist_ok=True)
    for path in (half, young):
        path.write_text("")
    month = 31 * 86_400
    for path, age in ((old, month), (half, 2 * 86_400), (place / "tidied", 2 * 86_400)):
        os.utime(path, (path.stat().st_mtime - age,) * 2)
    assert archive.run("check", "a.ngc", "b.ngc").code == 1
    assert [path.exists() for path in (old, half, young, *rest)][1:] == [False, True, True, True, True]
    assert (place / "tidied").stat().st_mtime > half.parent.stat().st_mtime - 60


def test_processes_share_it(archive):
    def names(seed: str) -> str:
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-m", "deburr", "check", "-v", "-j", "2"]
        return subprocess.run(command, env=environment, capture_output=True, text=True, check=False).stderr

    assert names("1").count("known from an earlier check") == 4
    archive.write("c.ngc", "G21\nM2\n")
    archive.write("d.ngc", "G21\nM2\n")
    # The programs look into the folder for the one that they call, and it has one more.
    first = names("2").count("known from an earlier check")
    assert (first, names("3").count("known from an earlier check")) == (0, 5)
