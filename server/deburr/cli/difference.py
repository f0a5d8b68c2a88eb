"""Two flat programs compared: a unified diff whose hunks say which source lines they come from."""

import re
from collections.abc import Iterator
from difflib import unified_diff

from deburr.cli.flat import Flat
from deburr.paths import working_folder

_HUNK = re.compile(r"@@ -([0-9]+)(?:,([0-9]+))? \+([0-9]+)(?:,([0-9]+))? @@")


def difference(one: Flat, other: Flat) -> Iterator[str]:
    """The lines of the diff; none if the programs are the same."""
    before, after = one.lines(), other.lines()
    old, new = (_short(flat.programs[0].file) for flat in (one, other))
    for line in unified_diff(before, after, old, new, lineterm=""):
        hunk = _HUNK.fullmatch(line)
        if hunk is None:
            yield line
            continue
        places = (_origin(one, int(hunk[1]), hunk[2]), _origin(other, int(hunk[3]), hunk[4]))
        yield f"{line} {' | '.join(place for place in places if place)}"


def _origin(flat: Flat, first: int, count: str | None) -> str:
    """Where the middle of a hunk comes from: its context is three lines on each side."""
    if flat.source_map is None or not len(flat.source_map):
        return ""
    size = int(count) if count is not None else 1
    at = min(max(first - 1, 0) + min(3, max(size - 1, 0)), len(flat.source_map) - 1)
    origin = flat.source_map.origin(at)
    frames = [
        f"{_short(frame.file)}:{frame.row + 1} ({frame.kind} {frame.number})" for frame in flat.source_map.stack(at)
    ]
    return " <- ".join([f"{_short(origin.file)}:{origin.row + 1}", *frames])


def _short(file: str) -> str:
    return file.removeprefix(f"{working_folder().rstrip('/')}/")
