"""Bytes: encodings, marks and padding; positions are those that an editor shows."""

import os

import pytest

from deburr.cli.disk import Disk
from deburr.paths import bounded
from deburr.source import NotAProgram, Source, read

FAULT = b"G0 X[1/0]\n"


def places(shell, data, *arguments):
    shell.write("a.ngc", data)
    ran = shell.run("check", "a.ngc", "--output-format", "concise", "-q", *arguments)
    return [" ".join(line.split(" ")[:3]).removeprefix("a.ngc:") for line in ran.out.splitlines()]


HEAD = b"G21 G90 G17\n"
TAIL = b"F100\nM2\n"
ZERO = "error rs274.divide-by-zero"
PADDING = "info rs274.nul-bytes"
MARK = "error rs274.byte-order-mark"


@pytest.mark.parametrize(
    ("data", "text", "encoding"),
    [
        (b"\xc3\xa4\xe2\x82\xac", "\xe4\u20ac", "utf-8"),
        (b"\xe4\x80", "\xe4\u20ac", "cp1252"),
        (b"\xe4\x81", "\xe4\x81", "latin-1"),
        (bytes(range(1, 256)), bytes(range(1, 256)).decode("latin-1"), "latin-1"),
        (b"", "", "utf-8"),
    ],
)
def test_decoding_never_fails(data, text, encoding):
    found = read(data)
    assert isinstance(found, Source)
    assert (found.text, found.encoding, found.bom) == (text, encoding, False)


def test_a_byte_order_mark_is_no_column(shell):
    assert read(b"\xef\xbb\xbfM2") == Source("M2", bom=True)
    program = b"\xef\xbb\xbfG21 G90 G17 (\xc3\xa4\xf0\x9f\x98\x80) G0 X[1/0]\nM2\n"
    assert places(shell, program, "--ignore", "rs274.byte-order-mark") == [f"1:25: {ZERO}"]


@pytest.mark.parametrize("start", [b"", b"\0\0", b"\n", b"\0\n"])
def test_a_byte_order_mark_is_said_where_the_program_starts(shell, start):
    padding = [f"1:1: {PADDING}"] if start.startswith(b"\0") else []
    assert places(shell, b"\xef\xbb\xbf" + start + HEAD + TAIL) == [f"1:1: {MARK}", *padding]


def test_a_byte_order_mark_is_no_fault_where_the_control_skips_it(shell):
    shell.write("a.cgt", b"\xef\xbb\xbf.@ \xc3\xa4 \n")
    assert "byte-order-mark" not in shell.run("check", "a.cgt").out


@pytest.mark.parametrize("comment", [b"(\xe4\x80)", "(ä€)".encode(), b"(\xe4\x81)"])
def test_columns_count_characters_not_bytes(shell, comment):
    assert places(shell, HEAD + comment + FAULT + TAIL) == [f"2:12: {ZERO}"]


@pytest.mark.parametrize("eol", [b"\n", b"\r\n", b"\r"])
def test_line_ends(shell, eol):
    # Editors and we end a line at a carriage return, too; RS274 does not, and that is said.
    alone = ["1:1: error rs274.line-ends"] if eol == b"\r" else []
    assert places(shell, (HEAD + FAULT + TAIL).replace(b"\n", eol)) == [*alone, f"2:8: {ZERO}"]


@pytest.mark.parametrize("sign", ["\f", "\v", "\x1c", "\u2028", "\x85"])
def test_other_signs_end_no_line(shell, sign):
    assert places(shell, HEAD + f"(a{sign}b)".encode() + FAULT + TAIL) == [f"2:13: {ZERO}"]


def test_padding_is_skipped_and_said(shell):
    program = HEAD + FAULT + TAIL
    assert places(shell, b"\0\0\0" + program) == [f"1:1: {PADDING}", f"2:8: {ZERO}"]
    assert places(shell, program + b"\0\0") == [f"2:8: {ZERO}", f"5:1: {PADDING}"]
    assert places(shell, program + b"\x1a") == [f"2:8: {ZERO}", f"5:1: {PADDING}"]
    assert places(shell, b"\0" + program + b"\x1a\0\0") == [f"1:1: {PADDING}", f"2:8: {ZERO}", f"5:1: {PADDING}"]
    assert places(shell, program + b"\x1a", "--ignore", "rs274.nul-bytes") == [f"2:8: {ZERO}"]


def test_padding_moves_the_first_line_only(shell):
    line = b"G21 G90 G17 G0 X[1/0]\nX[1/0] M2\x1a"
    assert places(shell, b"\0\0" + line) == [f"1:1: {PADDING}", f"1:22: {ZERO}", f"2:5: {ZERO}", f"2:10: {PADDING}"]


def test_padding_is_shown(shell):
    shell.write("a.ngc", b"\0\0G21 G90 G17\nM2\n")
    assert shell.run("check").out == (
        "info[rs274.nul-bytes]: 2 NUL bytes skipped: padding of a tape or a transfer, no part of the program\n"
        " --> a.ngc:1:1\n"
        "  |\n"
        "1 | \u2400\u2400G21 G90 G17\n"
        "  | ^^\n"
        "2 | M2\n"
        "  |\n"
        "\n"
        "Found 1 info in 1 file (1 checked)\n"
    )


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"G0\0X1\nM2\n", "a NUL byte at offset 2: this is no program"),
        (b"\xef\xbb\xbfG0\0X1\nM2\n", "a NUL byte at offset 5: this is no program"),
        (b"\0\0G0\0X1\0", "a NUL byte at offset 4: this is no program"),
        ("G0 X1\n".encode("utf-16"), "this is UTF-16, not a program that a control reads; save it as UTF-8"),
    ],
)
def test_other_nuls_are_refused(shell, data, reason):
    assert read(data) == NotAProgram(reason)
    shell.write("a.ngc", data)
    shell.write("b.ngc", HEAD + TAIL)
    for path in ("a.ngc", "."):
        ran = shell.run("check", path, "b.ngc")
        assert (ran.code, ran.out) == (2, "No findings (1 checked, 1 not checked)\n")
        assert ran.err == f"deburr: error: a.ngc: {reason}\n"


def test_devices_are_read_to_a_bound(shell, monkeypatch):
    monkeypatch.setattr("deburr.paths.MOST", 1_000)
    said = "/dev/zero: a device that gives more than 1,000 bytes, which is no program\n"
    for arguments in (("check",), ("check", "--dialect", "z32"), ("expand", "--dialect", "z32")):
        ran = shell.run(*arguments, "/dev/zero")
        assert (ran.code, ran.err) == (2, f"deburr: error: {said}")
    assert shell.run("check", "--dialect", "z32", "/dev/null").code == 0
    with open("/dev/zero", "rb") as endless, pytest.raises(OSError, match="1,000 bytes"):  # noqa: PTH123  A device.
        bounded(endless)


def test_a_binary_with_a_shared_extension_is_skipped_in_a_folder(shell):
    shell.write("a.tmp", b"MZ\0\1")
    assert shell.run("check").code == 0
    assert shell.run("check", "a.tmp").code == 2


def test_only_padding():
    assert read(b"\0\0\x1a") == Source("", lead="\0\0", tail="\x1a")
    assert read(b"\0\0") == Source("", lead="\0\0")


def test_the_disk_decodes_as_programs_are_decoded(tmp_path):
    (tmp_path / "b.ngc").write_bytes(b"\xef\xbb\xbf(\xe4)\0")
    (tmp_path / "a.ngc").write_bytes("(ä)".encode())
    disk, folder = Disk(), tmp_path.as_posix()
    assert disk.names(folder) == ("a.ngc", "b.ngc") and disk.names(f"{folder}/none") == ()
    assert (disk.read(f"{folder}/a.ngc"), disk.read(f"{folder}/none")) == ("(ä)", None)
    assert disk.read(f"{folder}/b.ngc") == "(ä)"
    assert disk.read(folder) is None


def test_a_named_pipe_is_refused_and_what_the_shell_gives_is_read(shell):
    os.mkfifo(shell.folder / "fifo.ngc")
    for command in ("check", "expand", "format", "explain-dialect"):
        ran = shell.run(command, "fifo.ngc")
        assert ran.code == 2 and "fifo.ngc: a named pipe, which may never end" in ran.err
    reading, writing = os.pipe()
    os.write(writing, b"G0 X1\nM2\n")
    os.close(writing)
    ran = shell.run("check", "--dialect", "rs274", f"/dev/fd/{reading}")
    os.close(reading)
    assert (ran.code, ran.out) == (0, "All checks passed (1 checked)\n")
