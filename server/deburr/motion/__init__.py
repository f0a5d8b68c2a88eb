"""Where a flat program goes: canonical moves, each with the flat line that makes it. Knows no source, no file, no picture.

`follow(lines)` reads a flat program into a `Path` (path.py), the record of its moves and events;
`measured` (measure.py) says what stands in it: bounds, lengths, times, tools.
"""

from deburr.motion.follow import follow
from deburr.motion.path import Arc, Event, Happening, Kind, Move, Note, Path

__all__ = ["Arc", "Event", "Happening", "Kind", "Move", "Note", "Path", "follow"]
