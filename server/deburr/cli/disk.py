"""The files on disk around a program. Paths are absolute, as the program's own path is; relative ones start at the working folder.

A setting that comes from a configuration file is absolute already; one that has its default,
and a name that stands in a program, is looked for beside the program.
"""

from collections.abc import Sequence

from deburr import paths, source


class Disk:
    """A host that reads the disk. Each file is read once in a run."""

    def __init__(self) -> None:
        self._texts: dict[str, str | None] = {}

    def read(self, path: str) -> str | None:
        """The text of a file, decoded as programs are."""
        if path not in self._texts:
            self._texts[path] = _text(path)
        return self._texts[path]

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder, in order."""
        try:
            return paths.names(folder)
        except OSError:
            return ()


def _text(path: str) -> str | None:
    try:
        return source.text(paths.data(path))
    except (OSError, ValueError):
        return None
