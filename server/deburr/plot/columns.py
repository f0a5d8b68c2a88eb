"""A toolpath for a viewer: what is said once of it, and chunks of packed columns. The other side is vscode-extension/viewer/data.ts."""

from __future__ import annotations

import sys
import zlib
from array import array
from base64 import b64encode
from collections.abc import Iterable, Iterator, Sequence
from operator import sub
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.motion import Kind
from deburr.motion.arcs import points
from deburr.plot.extent import Extent, Reach
from deburr.plot.notes import notes

if TYPE_CHECKING:
    from deburr.expand.source_map import SourceMap
    from deburr.motion import Path

CHUNK = 8_192
"""Moves of a chunk: a few milliseconds' work, a few hundred kilobytes at most."""
_FINEST = 1e-4
"""Millimetres: positions are whole multiples of this, or of more in programs that go further than a whole number would."""
_MOST = 2**30
_EFFORT = 1
"""What more effort saves, a sixth, is not worth ten times the time."""
_FINE = 16_000
"""Chords of arcs leave them by at most this part of the way across everything."""


class Toolpath(NamedTuple):
    """A program's moves, where each comes from, and the flat lines."""

    name: str
    path: Path
    source_map: SourceMap
    flat: Sequence[str]
    reach: Reach

    @property
    def chunks(self) -> int:
        """How many chunks there are; one at least."""
        return max(1, -(-len(self.path) // CHUNK))


class Scale(NamedTuple):
    """How fine positions and arcs are told, in millimetres."""

    quantum: float
    tolerance: float


def scale(made: Toolpath) -> Scale:
    """How fine a path is told, by how far it goes."""
    reach = made.reach.all or Extent(made.path.start, made.path.start)
    furthest = max(abs(value) for corner in (reach.low, reach.high) for value in corner)
    return Scale(max(_FINEST, furthest / _MOST), max(10 * _FINEST, reach.size / _FINE))


def header(made: Toolpath, fine: Scale, sources: Iterable[dict[str, str]]) -> dict[str, Any]:
    """What is said once. ``sources``: of each file of the map its name, and its URI or its packed text."""
    path = made.path
    told = list(notes(path))
    if len(path.arcs[0]):
        told.append(f"arcs are drawn in chords that leave them by at most {fine.tolerance:.3g} mm")
    return {
        "title": made.name,
        "quantum": fine.quantum,
        "moves": len(path),
        "chunks": made.chunks,
        "start": list(path.start),
        "bounds": {"all moves": made.reach.all, "cuts": made.reach.cuts},
        "kinds": [kind.name.lower() for kind in Kind],
        "tools": list(path.tools),
        "frameKinds": list(made.source_map.kinds),
        "notes": told,
        "sources": list(sources),
    }


def chunk(made: Toolpath, fine: Scale, number: int) -> dict[str, Any]:
    """Some moves with their points, a share of the frames, and the flat lines up to that of the last move."""
    path, chunks = made.path, made.chunks
    first, last = number * CHUNK, min(len(path), (number + 1) * CHUNK)
    rows = path.flat[first:last].tolist()
    sources, lines, frames = made.source_map.lines
    counts, xs, ys, zs = _vertices(path, first, last, fine.tolerance)
    columns: dict[str, Iterable[int]] = {
        "kind": path.kinds[first:last].tolist(),
        "tool": path.tool[first:last].tolist(),
        "row": rows,
        "source": [sources[row] for row in rows],
        "line": [lines[row] for row in rows],
        "frame": [frames[row] for row in rows],
        "vertices": counts,
    }
    for axis, values in zip("xyz", (xs, ys, zs)):
        columns[axis] = [round(value / fine.quantum) for value in values]
    total = len(made.source_map.frames[0])
    share = slice(total * number // chunks, total * (number + 1) // chunks)
    for name, column in zip(("Parent", "Source", "Row", "Kind", "Number"), made.source_map.frames):
        columns[f"frame{name}"] = column[share]
    begin = path.flat[first - 1] + 1 if first else 0
    end = path.flat[last - 1] + 1 if number + 1 < chunks else len(made.flat)
    text = "".join(f"{line}\n" for line in made.flat[begin:end])
    return {"columns": {name: packed(values) for name, values in columns.items()}, "text": packed_text(text)}


def every_chunk(made: Toolpath, fine: Scale) -> Iterator[dict[str, Any]]:
    """All chunks, in order."""
    return (chunk(made, fine, number) for number in range(made.chunks))


def packed(values: Iterable[int]) -> str:
    """A column: base 64 of deflated differences, 32 bits each, the lowest byte first."""
    column = array("i", values)
    differences = array("i", column[:1])
    differences.extend(map(sub, column[1:], column))
    if sys.byteorder == "big":
        differences.byteswap()
    return b64encode(zlib.compress(differences.tobytes(), _EFFORT)).decode()


def packed_text(text: str) -> str:
    """Lines, each with its end: base 64 of a deflated stream."""
    return b64encode(zlib.compress(text.encode("utf-8", "replace"), _EFFORT)).decode()


def _vertices(
    path: Path, first: int, last: int, tolerance: float
) -> tuple[list[int], list[float], list[float], list[float]]:
    """How many points each move has, and all of them: on arcs some between, else the end only."""
    counts = [1] * (last - first)
    ends = [list[float](column[first:last]) for column in (path.x, path.y, path.z)]
    if Kind.ARC not in path.kinds[first:last].tolist():
        return counts, ends[0], ends[1], ends[2]
    many: tuple[list[float], list[float], list[float]] = ([], [], [])
    for index in range(first, last):
        arc = path.arc(index)
        found = [path[index].end] if arc is None else list(points(arc, tolerance))
        counts[index - first] = len(found)
        for column, values in zip(many, zip(*found)):
            column.extend(values)
    return counts, many[0], many[1], many[2]
