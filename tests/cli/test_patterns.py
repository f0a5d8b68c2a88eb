"""Patterns of paths match what the library's match, and none of them takes long to say no."""

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
