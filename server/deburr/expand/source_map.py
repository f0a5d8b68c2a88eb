"""From each flat line back to its source: Source Map v3 (ECMA-426) with deburr's frames. Never holds text."""

from __future__ import annotations

import json
from array import array
from functools import lru_cache
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from deburr.fault import Frame

_DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

_AT_ONCE = 4_000
"""So many lines of a map are written together."""


class Origin(NamedTuple):
    """Where a flat line comes from: file, 0-based row, and the number of its frame (-1: none)."""

    file: str
    row: int
    frame: int


class Entry(NamedTuple):
    """A frame as the map keeps it: see `Frame`."""

    parent: int
    file: str
    row: int
    kind: str
    number: int


class SourceMap:
    """The map of one flat program, in parallel columns: 12 bytes a line, 20 a frame that emitted something."""

    def __init__(self) -> None:
        self.files: list[str] = []
        self._numbers: dict[str, int] = {}
        self._kinds: list[str] = []
        self._lines = (array("i"), array("i"), array("i"))
        self._frames = (array("i"), array("i"), array("i"), array("i"), array("i"))

    def __len__(self) -> int:
        return len(self._lines[0])

    def add(self, file: str, row: int, frame: Frame | None) -> None:
        """The origin of the next flat line."""
        sources, rows, frames = self._lines
        sources.append(self._file(file))
        rows.append(row)
        frames.append(-1 if frame is None else frame.id if frame.id >= 0 else self._kept(frame))

    def extend(self, file: str, rows: Sequence[int], frame: Frame | None) -> None:
        """The origins of the next flat lines, all of one file and frame."""
        if not rows:
            return
        self.add(file, rows[0], frame)
        sources, kept, frames = self._lines
        more = len(rows) - 1
        sources.extend(sources[-1:] * more)
        kept.extend(rows[1:])
        frames.extend(frames[-1:] * more)

    def keep(self, count: int) -> None:
        """Forget all lines but the first so many."""
        for column in self._lines:
            del column[count:]

    @property
    def lines(self) -> tuple[memoryview, memoryview, memoryview]:
        """Of each flat line the index of its file in ``files``, its 0-based row, and the number of its frame (-1: none)."""
        sources, rows, frames = (memoryview(column).toreadonly() for column in self._lines)
        return sources, rows, frames

    @property
    def frames(self) -> tuple[memoryview, ...]:
        """Of each frame the number of the one around it (-1: none), the index of its file, its row, the index of its kind in ``kinds``, and its number."""
        return tuple(memoryview(column).toreadonly() for column in self._frames)

    @property
    def kinds(self) -> tuple[str, ...]:
        """What frames can be."""
        return tuple(self._kinds)

    def origin(self, line: int) -> Origin:
        """Where a flat line (0-based) comes from."""
        sources, rows, frames = self._lines
        return Origin(self.files[sources[line]], rows[line], frames[line])

    def frame(self, number: int) -> Entry:
        """A frame by its number."""
        parent, source, row, kind, count = (column[number] for column in self._frames)
        return Entry(parent, self.files[source], row, self._kinds[kind], count)

    def stack(self, line: int) -> Iterator[Entry]:
        """The frames above a flat line, innermost first."""
        number = self.origin(line).frame
        while number >= 0:
            entry = self.frame(number)
            yield entry
            number = entry.parent

    def lines_of(self, file: str, row: int) -> list[int]:
        """The flat lines that a source line made, in order."""
        source = self._numbers.get(file, -1)
        sources, rows, _ = self._lines
        return [line for line, found in enumerate(rows) if found == row and sources[line] == source]

    def document(self, file: str, named: Callable[[str], str] = str) -> dict[str, Any]:
        """The map as a Source Map v3 document of a flat program. ``named`` turns paths into what the map calls them."""
        found: dict[str, Any] = json.loads("".join(self.texts(file, named)))
        return found

    def texts(self, file: str, named: Callable[[str], str] = str) -> Iterator[str]:
        """The document in pieces of JSON: as a whole it would weigh ten times as much as the map."""
        head = {"version": 3, "file": file, "sources": [named(each) for each in self.files], "names": []}
        yield f'{_json(head)[:-1]},"mappings":"'
        yield from _pieces(self._mappings(), ";")
        yield '","x_deburr_frames":['
        parents, sources, rows, kinds, numbers = self._frames
        said = [json.dumps(kind) for kind in self._kinds]
        frames = zip(parents, sources, rows, map(said.__getitem__, kinds), numbers)
        yield from _pieces((f"[{p},{s},{r},{k},{n}]" for p, s, r, k, n in frames), ",")
        yield '],"x_deburr_lines":['
        yield from _pieces((f"[{s},{r},{f}]" for s, r, f in zip(*self._lines)), ",")
        yield "]}"

    def _mappings(self) -> Iterator[str]:
        """One segment a line, from its column 0 to column 0 of its source line."""
        last_source = last_row = 0
        for source, row in zip(self._lines[0], self._lines[1]):
            yield f"A{_vlq(source - last_source)}{_vlq(row - last_row)}A"
            last_source, last_row = source, row

    def _file(self, file: str) -> int:
        number = self._numbers.get(file)
        if number is None:
            number = self._numbers[file] = len(self.files)
            self.files.append(file)
        return number

    def _kept(self, frame: Frame) -> int:
        """The number of a frame; it and those around it are kept the first time that they emit something."""
        fresh = []
        each: Frame | None = frame
        while each is not None and each.id < 0:
            fresh.append(each)
            each = each.parent
        for each in reversed(fresh):
            each.id = len(self._frames[0])
            parent = each.parent.id if each.parent is not None else -1
            row = (parent, self._file(each.file), each.row, self._kind(each.kind.value), each.number)
            for column, value in zip(self._frames, row):
                column.append(value)
        return frame.id

    def _kind(self, kind: str) -> int:
        if kind not in self._kinds:
            self._kinds.append(kind)
        return self._kinds.index(kind)


def _json(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))


def _pieces(texts: Iterator[str], between: str) -> Iterator[str]:
    """Texts joined by a sign, some thousands at a time."""
    sign = ""
    while block := between.join(islice(texts, _AT_ONCE)):
        yield sign + block
        sign = between


@lru_cache(maxsize=4096)
def _vlq(value: int) -> str:
    """A number in base 64 with the sign in its lowest bit."""
    rest = value << 1 if value >= 0 else (-value << 1) | 1
    text = ""
    while True:
        rest, digit = rest >> 5, rest & 31
        text += _DIGITS[digit | 32 if rest else digit]
        if not rest:
            return text
