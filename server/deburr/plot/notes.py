"""What a picture of a path does not show, in words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from deburr.motion.path import Flag

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.motion import Path

_FLAGS = {
    Flag.COMPENSATED: "cutter compensation is not drawn: what is shown is the way that was programmed",
    Flag.ASSUMED: "some moves start or end where only the machine knows; they are drawn as if its offsets were 0",
}


def notes(path: Path) -> Iterator[str]:
    """All that is to be said beside it."""
    met = set(path.flags)
    for flag, text in _FLAGS.items():
        if any(each & flag for each in met):
            yield text
    if path.beside:
        yield f"axes that are not drawn: {', '.join(path.beside)}"
    for note in path.notes:
        yield note.text
