"""The files around the programs of a session: open buffers before the disk. A text that was read is kept until its file changes."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence

from deburr import paths, source
from deburr.configfile import Configs
from deburr.detect import known_extensions

Stamp = tuple[int, int]
"""When a file was written, and its size."""
_SKIPPED = frozenset((".git", ".hg", ".svn", ".jj", ".venv", "venv", "node_modules", "__pycache__"))
_KEPT = 2_000


class Files:
    """A host over the disk and the buffers that are open. ``buffer``: the text of an open file, None for others; ``opened``: the open files."""

    def __init__(self, buffer: Callable[[str], str | None], opened: Callable[[], Iterable[str]]) -> None:
        self._buffer = buffer
        self._opened = opened
        self._texts: dict[str, tuple[Stamp, str]] = {}

    def read(self, path: str) -> str | None:
        """The text of a file as it is now."""
        text = self._buffer(path)
        return self._on_disk(path) if text is None else text

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder, in order; a file that is open but was never saved is there, too."""
        try:
            found = paths.names(folder)
        except (OSError, ValueError):
            found = []
        start = f"{folder.rstrip('/')}/"
        unsaved = {each[len(start) :].partition("/")[0] for each in self._opened() if each.startswith(start)}
        return found if unsaved <= set(found) else sorted({*found, *unsaved})

    def stamp(self, path: str) -> Stamp | None:
        """What tells one state of a file on disk from another; None if there is none."""
        try:
            found = os.stat(path)  # noqa: PTH116  paths are texts here.
        except (OSError, ValueError):
            return None
        return found.st_mtime_ns, found.st_size

    def _on_disk(self, path: str) -> str | None:
        stamp = self.stamp(path)
        kept = self._texts.get(path)
        if stamp is None or (kept is not None and kept[0] == stamp):
            return kept[1] if stamp is not None and kept is not None else None
        try:
            data = paths.data(path)
        except (OSError, ValueError):
            return None
        if len(self._texts) >= _KEPT:
            self._texts.clear()
        self._texts[path] = stamp, source.text(data)
        return self._texts[path][1]


def programs_in(folder: str, configs: Configs) -> Iterator[str]:
    """The files in a folder and below it that may be programs, in order; hidden and installed things are passed over."""
    extensions = known_extensions()
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries:
        path = paths.join(folder, entry.name)
        if entry.is_dir(follow_symlinks=False):
            if entry.name not in _SKIPPED:
                yield from programs_in(path, configs)
        elif path.endswith(paths.PART):
            continue
        elif paths.extension(path) in extensions or configs.of(path).dialect_of(path) is not None:
            yield path
