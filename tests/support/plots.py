"""Toolpaths for tests of plots: programs as text made into paths, maps in which each line comes from itself, and columns read again."""

from __future__ import annotations

import json
import re
import zlib
from array import array
from base64 import b64decode
from collections.abc import Mapping
from itertools import accumulate
from typing import Any

from deburr.expand.source_map import SourceMap
from deburr.motion import Path, follow
from deburr.plot.columns import Toolpath
from deburr.plot.extent import reach


def path_of(text: str) -> Path:
    """The path of a flat program."""
    return follow(text.split("\n"))


def toolpath(text: str, file: str = "/programs/part.ngc") -> Toolpath:
    """A flat program whose lines come from the same lines of a file."""
    lines, source_map = text.rstrip("\n").split("\n"), SourceMap()
    source_map.extend(file, range(len(lines)), None)
    path = follow(lines)
    return Toolpath("part.ngc", path, source_map, lines, reach(path))


def unpacked(column: str) -> list[int]:
    """The values of a packed column."""
    return list(accumulate(array("i", zlib.decompress(b64decode(column)))))


def unpacked_text(packed: str) -> str:
    """A packed text."""
    return zlib.decompress(b64decode(packed)).decode()


def data_of(page: str) -> Mapping[str, Any]:
    """The data that a page brings, by the names of their elements."""
    found = re.findall(r'<script type="application/json" id="([^"]+)">(.*?)</script>', page)
    return {name: json.loads(text) for name, text in found}


def rows(lines: int) -> str:
    """A program that mills a surface with so many moves, each one's feed in its own line: some thousand a row."""
    across = max(1, round(lines**0.5))
    moves = ((number // across, number % across) for number in range(lines))
    there = (f"G1 X{(across - 1 - at if row % 2 else at) * 0.1:.1f} Y{row * 0.1:.1f} Z{-((at * row) % 7) * 0.1:.1f}" for row, at in moves)  # fmt: skip
    return "\n".join(["G21 G90 G94 F600", "M3 S1000", *there, "M2", ""])
