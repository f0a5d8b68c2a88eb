"""`deburr plot`: what is written where, in which format, and what is refused."""

import re
import struct
import sys
import tomllib

import pytest

from support.code import ROOT
from support.plots import data_of, rows, unpacked, unpacked_text

LOOP = "G21 G90 F100\n#<n> = 0\no1 while [#<n> LT 3]\n  G1 X[#<n> * 10 + 1]\n  #<n> = [#<n> + 1]\no1 endwhile\nM2\n"
BAD = "G21 G0 X1\n#1 = [2 - 2]\nG0 X[5 / #1]\nM2\n"


def test_the_picture_goes_to_standard_output_as_flat_programs_do(shell):
    shell.write("loop.ngc", LOOP)
    code, out, err = shell.run("plot", "loop.ngc")
    assert (code, err) == (0, "")
    assert out.startswith("<svg ") and out.endswith("</svg>\n")
    assert shell.run("plot", "loop.ngc", "-o", "-") == (0, out, "")


def test_the_name_of_the_output_says_the_format(shell):
    shell.write("loop.ngc", LOOP)
    for name, head in (("a.svg", b"<svg "), ("a.PNG", b"\x89PNG"), ("a.html", b"<!DOCTYPE html>")):
        assert shell.run("plot", "loop.ngc", "-o", name) == (0, "", "")
        assert (shell.folder / name).read_bytes().startswith(head)


def test_a_png_is_twice_as_fine_as_the_picture(shell):
    shell.write("loop.ngc", LOOP)
    shell.run("plot", "loop.ngc", "-o", "a.png")
    width, _ = struct.unpack(">II", (shell.folder / "a.png").read_bytes()[16:24])
    assert width == 2400


def test_another_name_is_refused_with_the_way_out(shell):
    shell.write("loop.ngc", LOOP)
    code, out, err = shell.run("plot", "loop.ngc", "-o", "a.pdf")
    assert (code, out) == (2, "")
    assert "-o a.pdf: the name ends in none of .svg, .png and .html" in err and "--output-format" in err
    assert shell.run("plot", "loop.ngc", "-o", "a.pdf", "--output-format", "svg")[0] == 0
    code, _, err = shell.run("plot", "loop.ngc", "-o", "a.svg", "--output-format", "html")
    assert code == 2 and "-o a.svg: the name says svg, --output-format html" in err


def test_without_the_extra_a_png_is_refused_before_anything_is_run(shell, monkeypatch):
    shell.write("loop.ngc", LOOP)
    monkeypatch.setitem(sys.modules, "resvg_py", None)
    code, _, err = shell.run("plot", "loop.ngc", "-o", "a.png")
    assert code == 2 and "pip install 'resvg-py>=0.5,<0.6'" in err
    assert not (shell.folder / "a.png").exists()


def test_of_a_faulty_program_nothing_is_drawn(shell):
    shell.write("bad.ngc", BAD)
    code, out, err = shell.run("plot", "bad.ngc", "-o", "a.svg")
    assert (code, out) == (1, "")
    assert "rs274.divide-by-zero" in err and "nothing was drawn: 1 error" in err
    assert not (shell.folder / "a.svg").exists()


def test_a_part_is_drawn_on_demand_and_still_fails(shell):
    shell.write("bad.ngc", BAD)
    code, _, err = shell.run("plot", "bad.ngc", "-o", "a.svg", "--partial")
    assert code == 1 and "lines were drawn: 1 error" in err
    assert "X 0 to 1, Y 0 to 0" in (shell.folder / "a.svg").read_text()


def test_what_is_given_for_the_run_is_followed(shell):
    shell.write("arg.ngc", "G21 G90 F100\nG1 X#5\nM2\n")
    code, out, _ = shell.run("plot", "arg.ngc", "-D", "5=12.5")
    assert code == 0 and "X 0 to 12.5" in out


def test_the_configured_machine_is_followed(shell):
    shell.write("inch.ngc", "G90 F10\nG0 X2\nM2\n")
    shell.write("deburr.toml", '[machine]\nunit = "inch"\n')
    # No G20 or G21 stands there, so 2 are inches.
    assert "all moves: X 0 to 50.8" in shell.run("plot", "inch.ngc")[1]


def test_the_tool_table_is_followed(shell):
    shell.write("tool.ngc", "G21 G90 F100\nT1 M6 G43 H1\nG0 Z0\nM2\n")
    shell.write("tool.tbl", "T1 P1 Z30\n")
    code, out, _ = shell.run("plot", "tool.ngc", "--tool-table", "tool.tbl")
    assert code == 0 and "is not known" not in out


def test_what_is_read_is_not_written_over(shell):
    shell.write("part.svg", LOOP)
    code, _, err = shell.run("plot", "part.svg", "--dialect", "rs274", "-o", "part.svg")
    assert code == 2 and "that would write over" in err


def test_above_the_limit_it_says_what_was_left_out(shell, monkeypatch):
    from deburr.plot import svg

    shell.write("rows.ngc", rows(3_000))
    monkeypatch.setattr(svg.picture, "__defaults__", (400,))
    code, out, err = shell.run("plot", "rows.ngc")
    assert code == 0 and "of 3,000 segments are drawn; what is left out lies within" in err
    assert err.removeprefix("deburr: ").strip() in out


def test_the_page_holds_moves_sources_and_passes_and_asks_for_nothing(shell):
    shell.write("loop.ngc", LOOP)
    shell.run("plot", "loop.ngc", "-o", "a.html")
    page = (shell.folder / "a.html").read_text()
    data = data_of(page)
    header, columns = data["deburr-header"], data["deburr-chunk-0"]["columns"]
    assert unpacked(columns["line"]) == [3, 3, 3]
    assert [unpacked(columns["frameNumber"])[frame] for frame in unpacked(columns["frame"])] == [1, 2, 3]
    # The line behind the last end is one, too.
    assert unpacked_text(header["sources"][0]["text"]) == f"{LOOP}\n"
    assert "default-src 'none'" in page
    assert "src=" not in page.split("<script>")[0]


@pytest.mark.parametrize("end", ["svg", "html"])
def test_the_same_program_gives_the_same_bytes(shell, end):
    shell.write("loop.ngc", LOOP)
    written = []
    for name in (f"a.{end}", f"b.{end}"):
        shell.run("plot", "loop.ngc", "-o", name)
        written.append((shell.folder / name).read_bytes())
    assert written[0] == written[1]


def test_a_name_cannot_break_out_of_the_page(shell):
    name = "</title><script>alert(1)</script>.ngc".replace("/", "\u2215")
    shell.write(name, LOOP)
    assert shell.run("plot", name, "-o", "a.html")[0] == 0
    assert "<script>alert" not in (shell.folder / "a.html").read_text()


def test_what_is_said_to_install_is_what_the_extras_want():
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    said = [(ROOT / "server/deburr/cli" / name).read_text() for name in ("plot.py", "watch.py")]
    for text, extra in zip(said, ("png", "watch")):
        assert re.findall(r"pip install '([^']*)'", text) == extras[extra]
