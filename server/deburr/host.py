"""Where the core gets other files from: it asks a host and never opens one itself."""

from collections.abc import Sequence
from typing import Protocol


class Host(Protocol):
    """The files around a program. Paths are those that the program's own path is written like, with `/` between parts."""

    def read(self, path: str) -> str | None:
        """The text of a file; None if there is none."""

    def names(self, folder: str) -> Sequence[str]:
        """The names of the files and folders in a folder; none if there is no such folder."""


class NoFiles:
    """A host without any file: text that stands for itself, such as standard input."""

    def read(self, path: str) -> str | None:
        """No file."""
        return None

    def names(self, folder: str) -> Sequence[str]:
        """No names."""
        return ()


def sees_folder(host: Host, file: str) -> bool:
    """Whether files beside a program can be looked for, so that one can be missed: a text from standard input has no folder."""
    return not isinstance(host, NoFiles) and (not file or bool(host.names(file.rpartition("/")[0])))
