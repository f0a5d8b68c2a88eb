"""Patterns of paths as in `.gitignore`. A name that was made to be tried in vain costs no more than any other. Loaded only where there are patterns."""

import re
from collections.abc import Iterable
from typing import Literal
from warnings import catch_warnings, simplefilter

from pathspec import GitIgnoreSpec
from pathspec.patterns.gitignore.spec import GitIgnoreSpecPattern

_STAR = "[^/]*"


class Pattern(GitIgnoreSpecPattern):
    """The library's pattern, whose stars do not try all ways to share a name among them."""

    @staticmethod
    def _translate_segment_glob(pattern: str, range_error: Literal["literal", "raise"]) -> str:
        return linear(GitIgnoreSpecPattern._translate_segment_glob(pattern, range_error))


def spec(lines: Iterable[str]) -> GitIgnoreSpec:
    """What lines of patterns say of paths. One that is no pattern means no path, and leaves the others as they are."""
    return GitIgnoreSpec([found for line in lines if (found := _read(line)) is not None])


def is_pattern(line: str) -> bool:
    """Whether a line can be read as a pattern: not `\\`, which hides nothing, nor `[z-a]`, which has nothing in it."""
    return _read(line) is not None


def _read(line: str) -> Pattern | None:
    with catch_warnings():
        # What Python may one day read otherwise is no matter of the one who wrote the pattern.
        simplefilter("ignore", FutureWarning)
        try:
            return Pattern(line)
        except (ValueError, re.error):
            return None


def linear(segment: str) -> str:
    """The expression for one segment of a path, matching the same names: where a star ends is settled by the first place at which what follows fits.

    All between two stars has one length, so that a later place leaves less for the rest and never more; only the last star may go on.
    """
    first, *others = segment.split(_STAR)
    if not others:
        return segment
    return first + "".join(f"(?>[^/]*?{each})" for each in others[:-1] if each) + _STAR + others[-1]
