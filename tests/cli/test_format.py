"""`deburr format`: what is written where, what is said, and which exit code."""

import pytest

ROUGH = "o1 if[1]\ng0x1\no1 endif\nM2\n"
SMOOTH = "o1 if [1]\n  g0 x1\no1 endif\nM2\n"


def test_files_are_laid_out_in_place(shell):
    rough, smooth = shell.write("a/rough.ngc", ROUGH), shell.write("smooth.ngc", SMOOTH)
    shell.write("notes.md", "g0x1")
    shell.write("fanuc.nc", "g0x1")
    before = smooth.stat()
    assert shell.run("format") == (0, "1 file reformatted, 1 file left unchanged, 1 file skipped: no dialect\n", "")
    assert rough.read_text() == SMOOTH
    assert (smooth.stat().st_mtime_ns, smooth.stat().st_ino) == (before.st_mtime_ns, before.st_ino)
    assert (shell.folder / "fanuc.nc").read_text() == "g0x1"
    assert shell.run("format", "a", "smooth.ngc") == (0, "2 files left unchanged\n", "")
    assert shell.run("format", "-q") == (0, "", "")


def test_check_names_the_files_that_would_change(shell):
    path = shell.write("a/rough.ngc", ROUGH)
    shell.write("smooth.ngc", SMOOTH)
    said = "Would reformat: a/rough.ngc\n1 file would be reformatted, 1 file already formatted\n"
    assert shell.run("format", "--check") == (1, said, "")
    assert path.read_text() == ROUGH
    assert shell.run("format", "--check", "smooth.ngc") == (0, "1 file already formatted\n", "")


def test_diff_shows_what_would_change(shell):
    path = shell.write("rough.ngc", b"\xef\xbb\xbfg0x1\r\nM2 ")
    expected = "--- rough.ngc\n+++ rough.ngc\n@@ -1,2 +1,2 @@\n-\ufeffg0x1\r\n-M2 \n\\ No newline at end of file\n+\ufeffg0 x1\r\n+M2\n\\ No newline at end of file\n"
    for options in (("--diff",), ("--diff", "--check")):
        assert shell.run("format", *options) == (1, expected, "1 file would be reformatted\n")
    assert path.read_bytes() == b"\xef\xbb\xbfg0x1\r\nM2 "
    shell.write("rough.ngc", SMOOTH)
    assert shell.run("format", "--diff") == (0, "", "1 file already formatted\n")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b"\xef\xbb\xbfg0x1 (\xc3\xa9)\r\nM2\r", b"\xef\xbb\xbfg0 x1 (\xc3\xa9)\r\nM2\r"),
        (b"g0x1 (\xe9 \x80)\nM2", b"g0 x1 (\xe9 \x80)\nM2"),
        (b"g0x1 (\x81)\nM2", b"g0 x1 (\x81)\nM2"),
        (b"\xef\xbb\xbfg0x1 (\xe9)\n", b"\xef\xbb\xbfg0 x1 (\xe9)\n"),
        (b"\0\0g0x1\nM2\n\x1a", b"\0\0g0 x1\nM2\n\x1a"),
        (b"", b""),
    ],
)
def test_bytes_around_and_inside_stay_as_they_are(shell, old, new):
    path = shell.write("a.ngc", old)
    assert shell.run("format").code == 0
    assert path.read_bytes() == new


def test_links_are_followed_and_modes_kept(shell):
    path = shell.write("real/a.ngc", ROUGH)
    path.chmod(0o754)
    (shell.folder / "link.ngc").symlink_to(path)
    assert shell.run("format", "link.ngc").code == 0
    assert (shell.folder / "link.ngc").is_symlink()
    assert (path.read_text(), path.stat().st_mode & 0o777) == (SMOOTH, 0o754)
    assert list(path.parent.iterdir()) == [path]


def test_a_file_that_must_not_be_written_is_left_and_said(shell, monkeypatch):
    path = shell.write("a.ngc", ROUGH)
    monkeypatch.setattr("os.access", lambda path, mode: False)
    assert shell.run("format") == (
        2,
        "1 file not formatted\n",
        "deburr: error: a.ngc: cannot be written: Permission denied\n",
    )
    assert path.read_text() == ROUGH


def test_standard_input_goes_to_standard_output(shell):
    assert shell.run("format", "-", "--dialect", "rs274", stdin=ROUGH.encode())[:2] == (0, SMOOTH)
    ran = shell.run("format", "--stdin-filename", "a.mgc", stdin=b"#FILE   a\r\n")
    assert ran == (0, "#FILE a\r\n", "1 file reformatted\n")
    shell.write("deburr.toml", '[format]\nindent = 3\ncase = "canonical"\n')
    ran = shell.run("format", "-q", "--stdin-filename", "a.ngc", stdin=ROUGH.encode())
    assert ran == (0, SMOOTH.replace("  g0 x1", "   G0 X1"), "")
    ran = shell.run("format", "--check", "--stdin-filename", "a.ngc", stdin=ROUGH.encode())
    assert ran == (1, "Would reformat: a.ngc\n1 file would be reformatted\n", "")
    ran = shell.run("format", "-", stdin=b"g0x1")
    assert ran.code == 2 and "say which with --dialect" in ran.err and ran.out == ""


def test_what_is_left_is_said(shell):
    path = shell.write("a.ngc", "g0x1 &\n o1 if[1]\ng0x1\ng0x1 (a (b)\n")
    ran = shell.run("format")
    assert ran == (
        0,
        "1 file reformatted\n",
        "deburr: warning: a.ngc: 2 lines are left as written because of faults, which `deburr check` names\n"
        "deburr: warning: a.ngc: indentation is left as written because blocks do not pair; `deburr check` says where\n",
    )
    assert path.read_text() == "g0x1 &\n o1 if [1]\ng0 x1\ng0x1 (a (b)\n"
    assert shell.run("format", "-q") == (0, "", "")


def test_what_cannot_be_read(shell):
    shell.write("a.ngc", ROUGH)
    shell.write("b.ngc", b"G0\0X1")
    ran = shell.run("format", "nope.ngc", "a.ngc", "b.ngc")
    assert (ran.code, ran.out) == (2, "1 file reformatted, 2 files not formatted\n")
    assert "nope.ngc: no such file or folder" in ran.err and "b.ngc: a NUL byte" in ran.err
    assert shell.run("format", "--dialect", "z33").code == 2
    (shell.folder / "empty").mkdir()
    assert shell.run("format", "empty") == (0, "", "deburr: warning: no programs found under the given paths\n")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("indent = 17", "`indent` must be a number from 0 to 16, not 17"),
        ("indent = -1", "`indent` must be a number from 0 to 16, not -1"),
        ("indent = true", "`indent` must be a number from 0 to 16, not True"),
        ("indent = '2'", '`indent` must be a number from 0 to 16, not "2"'),
        ("indent-style = 'tabs'", '`indent-style` must be "space" or "tab", not "tabs"; did you mean `tab`?'),
        ("case = 'upper'", '`case` must be "keep" or "canonical", not "upper"'),
    ],
)
def test_a_configuration_that_cannot_be_used(shell, text, message):
    path = shell.write("a.ngc", ROUGH)
    shell.write("deburr.toml", f"[format]\n{text}\n")
    ran = shell.run("format")
    assert (ran.code, ran.out) == (2, "") and f":2: {message}" in ran.err
    assert path.read_text() == ROUGH


@pytest.mark.parametrize(
    ("text", "lead"), [("indent = 0", ""), ("indent = 4", "    "), ("indent-style = 'tab'", "\t"), ("", "  ")]
)
def test_the_indentation_that_is_configured(shell, text, lead):
    path = shell.write("a.ngc", ROUGH)
    other = shell.write("other.toml", f"[format]\n{text}\n")
    assert shell.run("format", "--config", str(other)).code == 0
    assert path.read_text() == SMOOTH.replace("  ", lead)


def test_a_section_that_the_end_of_the_file_ends_is_no_block_without_an_end(shell):
    path = shell.write("a.cgt", "@START\nG90\n@END\n#IF(#V1=1)<\nM30\n>\n")
    ran = shell.run("format")
    assert (ran.code, ran.err) == (0, "")
    assert path.read_text() == "@START\nG90\n@END\n#IF(#V1=1)<\nM30\n>\n"
    shell.write("a.cgt", "@START\n#IF(#V1=1)<\nG90\n@END\nM30\n")
    assert "indentation is left as written because blocks do not pair" in shell.run("format").err


def test_sections_that_a_machine_file_makes_tables_are_read_as_such(shell):
    shell.write("deburr.toml", '[cgt]\nmachine = "mill.toml"\n')
    shell.write("mill.toml", '[words]\nMYTAB = "table"\n')
    text = "@MYTAB\n0,#EVAL( #V1=1 )\n@\n"
    path = shell.write("a.cgt", text)
    assert shell.run("format").code == 0
    assert path.read_text() == text
    (shell.folder / "deburr.toml").unlink()
    assert shell.run("format").code == 0
    assert path.read_text() == text.replace("( #V1=1 )", "(#V1=1)")
