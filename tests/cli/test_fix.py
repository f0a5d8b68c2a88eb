"""`deburr check --fix`: what is written, what is said, and which exit code."""

import os

import pytest

ROUGH = "(P)\ng0 x1\n!HA=1;;HB=2!\nG0 Y<SIN(30)>\nM30\n"
SAFE = "(P)\nG0 X1\n!HA=1;HB=2!\nG0 Y<SIN(30)>\nM30\n"
ALL = "(P)\nG0 X1\n!HA=1;HB=2!\nG0 Y<SN(30)>\nM30\n"


def test_what_is_safe_is_mended_and_the_rest_reported(shell):
    path = shell.write("a.z32", ROUGH)
    path.chmod(0o640)
    ran = shell.run("check", "--fix", "--output-format", "concise")
    assert path.read_text() == SAFE
    assert path.stat().st_mode & 0o777 == 0o640
    assert (ran.code, ran.out.splitlines()[-1]) == (1, "Found 1 error in 1 file (1 checked, 2 fixed)")
    assert ran.out.startswith("a.z32:4:6: error z32.function-unknown ")
    assert sorted(each.name for each in shell.folder.iterdir()) == ["a.z32"]


def test_guesses_are_made_when_asked_for(shell):
    path = shell.write("a.z32", ROUGH)
    assert shell.run("check", "--fix", "--unsafe-fixes") == (0, "All checks passed (1 checked, 3 fixed)\n", "")
    assert path.read_text() == ALL
    before = path.stat().st_mtime_ns
    assert shell.run("check", "--fix", "--unsafe-fixes") == (0, "All checks passed (1 checked)\n", "")
    assert path.stat().st_mtime_ns == before


def test_without_it_nothing_is_written(shell):
    path = shell.write("a.z32", ROUGH)
    shell.run("check", "--unsafe-fixes")
    assert path.read_text() == ROUGH


def test_diff_shows_and_writes_nothing(shell):
    path = shell.write("a.z32", ROUGH)
    expected = "--- a.z32\n+++ a.z32\n@@ -1,5 +1,5 @@\n (P)\n-g0 x1\n-!HA=1;;HB=2!\n+G0 X1\n+!HA=1;HB=2!\n G0 Y<SIN(30)>\n M30\n"
    assert shell.run("check", "--diff") == (1, expected, "Would fix 2 findings in 1 file\n")
    assert shell.run("check", "--diff", "-q") == (1, expected, "")
    assert path.read_text() == ROUGH
    shell.write("a.z32", ALL)
    assert shell.run("check", "--diff") == (0, "", "Nothing to fix\n")


@pytest.mark.parametrize(
    "data", [b"(P \xe4)\r\ng0 x1\r\nM30", b"\xef\xbb\xbf(P)\r\ng0 x1\r\nM30\r\n\x1a", b"\0\0g0 x1\nM30\n"]
)
def test_encoding_line_ends_and_padding_stay(shell, data):
    path = shell.write("a.z32", data)
    shell.run("check", "--fix")
    assert path.read_bytes() == data.replace(b"g0 x1", b"G0 X1")


def test_standard_input_comes_back_mended(shell):
    ran = shell.run("check", "--fix", "--stdin-filename", "a.z32", "-", stdin=ROUGH.replace("\n", "\r\n").encode())
    assert ran.out == SAFE.replace("\n", "\r\n")
    assert "z32.function-unknown" in ran.err and ran.code == 1


def test_a_file_that_cannot_be_written_is_said(shell):
    path = shell.write("a.z32", ROUGH)
    path.chmod(0o444)
    if os.access(path, os.W_OK):
        path.unlink()
        (shell.folder / "real").mkdir()
        path.symlink_to(shell.folder / "real" / "gone.z32")
        assert shell.run("check", "--fix", "a.z32").code == 2
        return
    ran = shell.run("check", "--fix", "a.z32")
    assert ran.code == 2 and "a.z32: cannot be written" in ran.err


def test_many_files_on_several_cores(shell):
    for number in range(4):
        shell.write(f"{number}.z32", ROUGH)
    ran = shell.run("check", "--fix", "-j", "2")
    assert ran.out.splitlines()[-1] == "Found 4 errors in 4 files (4 checked, 8 fixed)"
    assert {path.read_text() for path in shell.folder.iterdir()} == {SAFE}


@pytest.mark.parametrize(("reads", "left"), [("#<_metric>", False), ("#<_line>", True), ("# <_ LINE>", True)])
def test_no_line_goes_where_the_program_reads_their_numbers(shell, reads, left):
    text = f"(deburr: allow rs274.divide-by-zero)\nG21\n(debug, {reads})\n#1 = [{reads}]\nM2\n"
    path = shell.write("a.ngc", text)
    shell.run("check", "--fix")
    assert (path.read_text() == text) is left
    shell.run("check", "--fix", "--unsafe-fixes")
    assert path.read_text() == text.partition("\n")[2]
