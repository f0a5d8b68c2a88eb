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
    hunk, head = None, list[str]()
    for line in unified_diff(before, after, old, new, lineterm=""):
        if (found := _HUNK.fullmatch(line)) is not None:
            hunk, head = found, [line]
        elif hunk is not None and line.startswith(" "):
            head.append(line)
        elif hunk is not None:
            same = len(head) - 1
            places = (_origin(one, int(hunk[1]) + same, hunk[2]), _origin(other, int(hunk[3]) + same, hunk[4]))
            yield f"{head[0]} {' | '.join(place for place in places if place)}"
            yield from head[1:]
            yield line
            hunk = None
        else:
            yield line


def _origin(flat: Flat, changed: int, count: str | None) -> str:
    """Where the first changed line of a hunk comes from, counted from 1; of a side that has none there, the line in front of which it would stand."""
    if flat.source_map is None or not len(flat.source_map):
        return ""
    at = min(max(changed - (count != "0"), 0), len(flat.source_map) - 1)
    origin = flat.source_map.origin(at)
    frames = [
        f"{_short(frame.file)}:{frame.row + 1} ({frame.kind} {frame.number})" for frame in flat.source_map.stack(at)
    ]
    return " <- ".join([f"{_short(origin.file)}:{origin.row + 1}", *frames])


def _short(file: str) -> str:
    return file.removeprefix(f"{working_folder().rstrip('/')}/")
