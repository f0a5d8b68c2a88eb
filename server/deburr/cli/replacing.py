"""Files that are written whole or not at all."""

import os
from errno import EACCES, EISDIR
from pathlib import Path
from typing import IO


class replacing:
    """A file that appears under its name when all of it is written, or not at all. Links are followed, modes kept; what is no regular file is written into."""

    def __init__(self, path: str) -> None:
        self._said, self._path = path, Path(path).resolve()
        self._device = self._path.exists() and not self._path.is_file()
        self._part = self._path.with_name(f".{self._path.name}.{os.getpid()}.part")

    def __enter__(self) -> IO[bytes]:
        if self._path.is_dir():
            raise IsADirectoryError(EISDIR, os.strerror(EISDIR), self._said)
        if self._path.exists() and not os.access(self._path, os.W_OK):
            raise PermissionError(EACCES, os.strerror(EACCES), self._said)
        try:
            self._out = (self._path if self._device else self._part).open("wb")
        except OSError as error:
            error.filename = self._said
            raise
        return self._out

    def __exit__(self, kind: object, *_: object) -> None:
        self._out.close()
        if self._device:
            return
        if kind is None:
            if self._path.exists():
                self._part.chmod(self._path.stat().st_mode & 0o7777)
            self._part.replace(self._path)
        else:
            self._part.unlink(missing_ok=True)
