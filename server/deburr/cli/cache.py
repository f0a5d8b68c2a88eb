"""Results of earlier checks, kept on disk by the content of all that decided them. Knows nothing of what is kept.

An entry has a name made of everything that is known before a check: the program's path and bytes, its configuration, the
options, deburr itself. It is written whole or not at all and carries the digest of its own content, so one that is
damaged or cut short is none. What a hand has written into it is believed, as it is of every file below the folder.
"""

import os
from time import time
from typing import Any

from deburr import paths
from deburr.cli.fingerprint import digest

FOLDER = ".deburr_cache"
VARIABLE = "DEBURR_CACHE_DIR"
_TAG = "Signature: 8a477f597d28d172789f06886806bc55\n# Results that deburr keeps; they can be taken away at any time.\n"
"""What tells backup programs that a folder is a cache (bford.info/cachedir)."""
_DAY = 86_400
_OLD = 30 * _DAY
"""Seconds after which an entry that nobody asked for is taken away."""


class Cache:
    """The entries in a folder. Nothing that goes wrong with it is more than a miss."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def get(self, name: str) -> Any:
        """The entry of that name; None if there is none that is whole."""
        from json import loads

        path = self._path(name)
        try:
            with open(path, "rb") as file:  # noqa: PTH123  pathlib is not loaded for this.
                mark, _, body = file.read().partition(b"\n")
                age = time() - os.fstat(file.fileno()).st_mtime
            if mark.decode("ascii") != digest(name, body):
                return None
            if age > _DAY:
                os.utime(path)
            return loads(body)
        except (OSError, ValueError, RecursionError):
            return None

    def put(self, name: str, entry: Any) -> None:
        """Keep an entry; one of that name is replaced."""
        from json import dumps

        body = dumps(entry, separators=(",", ":"))
        path = self._path(name)
        try:
            os.makedirs(paths.parent(path), exist_ok=True)  # noqa: PTH103
            _write(path, f"{digest(name, body)}\n{body}")
        except OSError:
            return

    def _path(self, name: str) -> str:
        return f"{self.folder}/{name[:2]}/{name[2:]}"


def opened(folder: str) -> Cache | None:
    """The cache for programs that are checked from a folder; None if it cannot be written.

    It lies in `.deburr_cache` there, or where DEBURR_CACHE_DIR says. A link is not followed: it may lead anywhere.
    """
    said = os.environ.get(VARIABLE)
    place = paths.absolute(said) if said else paths.join(folder, FOLDER)
    if not said and os.path.islink(place):  # noqa: PTH114
        return None
    try:
        os.makedirs(place, exist_ok=True)  # noqa: PTH103
        for name, text in ((".gitignore", "*\n"), ("CACHEDIR.TAG", _TAG)):
            if not paths.exists(paths.join(place, name)):
                _write(paths.join(place, name), text)
        if not os.access(place, os.W_OK):
            return None
        _tidied(place)
    except OSError:
        return None
    return Cache(place)


def _tidied(place: str) -> None:
    """Once a day, take away what is old, and what an interrupted run has left half written."""
    stamp, now = paths.join(place, "tidied"), time()
    if paths.exists(stamp) and now - os.stat(stamp).st_mtime < _DAY:  # noqa: PTH116
        return
    _write(stamp, "")
    for folder in os.scandir(place):
        if len(folder.name) == 2 and folder.is_dir(follow_symlinks=False):
            for entry in os.scandir(folder):
                age = now - entry.stat(follow_symlinks=False).st_mtime
                if age > (_DAY if entry.name.endswith(paths.PART) else _OLD):
                    os.unlink(entry)  # noqa: PTH108


def _write(path: str, text: str) -> None:
    from deburr.cli.replacing import replacing

    with replacing(path) as out:
        out.write(text.encode("ascii"))
