"""Patterns of paths match what the library's match, and none of them takes long to say no."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pathspec import GitIgnoreSpec

from deburr.patterns import spec

PATTERNS = st.lists(
    st.sampled_from(["*", "a", "b", "?", "[ab]", "[!a]", "/", "**", ".", "\\*", "!"]), min_size=1, max_size=8
).map("".join)
PATHS = st.text("ab./*", min_size=1, max_size=10).map(lambda path: path.strip("/") or "a")


@given(st.lists(PATTERNS, max_size=3), PATHS)
def test_the_same_paths_are_meant(patterns: list[str], path: str) -> None:
    try:
        library = GitIgnoreSpec.from_lines(patterns)
    except ValueError:
        return
    assert spec(patterns).check_file(path).include is library.check_file(path).include, (patterns, path)


def test_what_is_no_pattern_means_no_path_and_leaves_the_others() -> None:
    found = spec(["[z-a]*", "\\", "*.txt", "[[a]x"])
    assert [path for path in ("z", "[z-a]", "\\", "b.txt", "[x", "ax") if found.match_file(path)] == [
        "b.txt",
        "[x",
        "ax",
    ]


@pytest.mark.parametrize("table", ['[files]\n"[z-a]" = "rs274"', "[check.per-file-ignores]\n'!\\' = ['rs274']"])
def test_a_configuration_with_what_is_no_pattern_is_refused(shell, table: str) -> None:
    shell.write("deburr.toml", f"{table}\n")
    shell.write("a.ngc", "M2\n")
    done = shell.run("check", "a.ngc")
    assert done.code == 2
    assert "deburr.toml:2: `" in done.err
    assert "is no pattern of paths" in done.err


def test_a_faulty_line_of_gitignore_leaves_the_others(shell) -> None:
    shell.write(".gitignore", "[z-a]\nold*\n")
    for name in ("old.ngc", "new.ngc"):
        shell.write(name, "G21 G90 G17\nM2 (a (b)\n")
    done = shell.run("check", "--output-format", "concise")
    assert "new.ngc" in done.out
    assert "old.ngc" not in done.out
