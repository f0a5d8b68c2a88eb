"""Files that are written whole or not at all: the only way in which deburr writes any. Whatever ends it leaves the old file or the new one."""

import os
from contextlib import suppress
from errno import EACCES, EEXIST, EISDIR
from time import time
from typing import IO

from deburr import paths

_PLACES = 4
"""So many may write one file at a time under names that are known, so that what an interrupted one left is found again."""
_OLD = 3_600
"""Seconds after which what is half written is nobody's any more."""
_NAME = 60
"""Characters of a file's name in that of its part: together they are no longer than a name may be."""


class replacing:
    """A file that appears under its name when all of it is written, or not at all. Links are followed, modes kept; what is no regular file is written into.

    ``new``: one that is there already is left alone, with FileExistsError. What an interrupted run has left beside the
    file is taken for no program, and the next one that writes the file takes it away when it is an hour old.
    """

    def __init__(self, path: str, *, new: bool = False) -> None:
        self._said, self._path, self._new = path, os.path.realpath(path), new
        self._device = paths.exists(self._path) and not paths.is_file(self._path)
        self._part = ""

    def __enter__(self) -> IO[bytes]:
        if paths.is_folder(self._path):
            raise self._error(IsADirectoryError, EISDIR)
        if paths.exists(self._path) and self._new:
            raise self._error(FileExistsError, EEXIST)
        if paths.exists(self._path) and not os.access(self._path, os.W_OK):
            raise self._error(PermissionError, EACCES)
        try:
            self._out = open(self._path, "wb") if self._device else self._opened()  # noqa: PTH123
        except OSError as error:
            error.filename = self._said
            raise
        return self._out

    def __exit__(self, kind: object, *_: object) -> None:
        try:
            self._out.close()
            if kind is None and not self._device:
                self._put()
        except OSError as error:
            error.filename, error.filename2 = self._said, None
            raise
        finally:
            if self._part:
                with suppress(OSError):
                    os.unlink(self._part)  # noqa: PTH108

    def _opened(self) -> IO[bytes]:
        folder, name = os.path.split(self._path)
        places = [os.path.join(folder, f".{name[:_NAME]}.{at}{paths.PART}") for at in range(_PLACES)]  # noqa: PTH118
        for place in places:
            _forget(place)
        for place in (*places, os.path.join(folder, f".{name[:_NAME]}.{os.getpid()}{paths.PART}")):  # noqa: PTH118
            with suppress(FileExistsError):
                out = open(place, "xb")  # noqa: PTH123, SIM115
                self._part = place
                return out
        raise self._error(FileExistsError, EEXIST)

    def _put(self) -> None:
        if self._new:
            with suppress(NotImplementedError, PermissionError):
                # A link is refused where a file has come in the meantime. Not all disks have them.
                os.link(self._part, self._path)
                return
        if paths.exists(self._path):
            os.chmod(self._part, os.stat(self._path).st_mode & 0o7777)  # noqa: PTH101, PTH116
        os.replace(self._part, self._path)  # noqa: PTH105
        self._part = ""

    def _error(self, kind: type[OSError], number: int) -> OSError:
        return kind(number, os.strerror(number), self._said)


def _forget(place: str) -> None:
    """Take away what somebody left long ago."""
    with suppress(OSError):
        if time() - os.stat(place).st_mtime > _OLD:  # noqa: PTH116
            os.unlink(place)  # noqa: PTH108
