"""The files on disk around a program. Paths are absolute, as the program's own path is; relative ones start at the working folder.

A setting that comes from a configuration file is absolute already; one that has its default,
and a name that stands in a program, is looked for beside the program.
"""

from collections.abc import Sequence

from deburr import paths, source


class Disk:
    """A host that reads the disk. Each file is read and each folder listed once in a run."""

    def __init__(self) -> None:
        self._texts: dict[str, str | None] = {}
        self._names: dict[str, tuple[str, ...]] = {}
        self._digests: dict[str, str] = {}
        self._listed: dict[str, str] = {}

    def read(self, path: str) -> str | None:
        """The text of a file, decoded as programs are."""
        if path not in self._texts:
            data = _data(path)
            self._texts[path] = None if data is None else source.text(data)
            # What was asked before may be of another state of the file than what is read now.
            self._digests.pop(path, None)
        return self._texts[path]

    def names(self, folder: str) -> Sequence[str]:
        """The names in a folder, in order."""
        if folder not in self._names:
            try:
                self._names[folder] = tuple(paths.names(folder))
            except OSError:
                self._names[folder] = ()
        return self._names[folder]

    def digest(self, path: str) -> str:
        """What tells the text of a file from any other; "" if there is none."""
        if path not in self._digests:
            from deburr.cli.fingerprint import digest

            if path in self._texts:
                text = self._texts[path]
            else:
                data = _data(path)
                text = None if data is None else source.text(data)
            self._digests[path] = "" if text is None else digest(text)
        return self._digests[path]

    def listed(self, folder: str) -> str:
        """What tells the names in a folder from any others."""
        if folder not in self._listed:
            from deburr.cli.fingerprint import digest

            self._listed[folder] = digest(*self.names(folder))
        return self._listed[folder]


def _data(path: str) -> bytes | None:
    try:
        return paths.data(path)
    except (OSError, ValueError):
        return None
