# pathlib costs more to load than a small program takes to check.
# ruff: noqa: PTH100, PTH109, PTH110, PTH112, PTH113, PTH116, PTH118, PTH120, PTH122, PTH123, PTH202, PTH208
"""The few things that are asked of the file system. A path is a text, absolute once it is known, with `/` between its parts."""

import os
import os.path
import stat
from errno import EFBIG, ENOENT, ENOTSUP
from typing import BinaryIO

MOST = 64 * 1024 * 1024
"""Bytes that are read from a device: some never end."""
PART = ".deburr-part"
"""The end of the names under which files are being written: they are nobody's, and no program."""


def absolute(path: str, folder: str = "") -> str:
    """The path from the root, seen from a folder (default: the working folder). Links are not followed."""
    return os.path.abspath(os.path.join(folder, path)).replace(os.sep, "/")


def real(path: str) -> str:
    """The path with all links followed: what two names of one file have in common."""
    return os.path.realpath(path).replace(os.sep, "/")


def parent(path: str) -> str:
    """The folder that a file or folder is in; the root's is the root."""
    return os.path.dirname(path)


def above(folder: str) -> list[str]:
    """A folder and all that it is in, innermost first."""
    found = [folder]
    while (outer := parent(found[-1])) != found[-1]:
        found.append(outer)
    return found


def join(folder: str, name: str) -> str:
    """The path of a name in a folder."""
    return f"{folder.rstrip('/')}/{name}"


def extension(path: str) -> str:
    """The extension in small letters, with its dot."""
    return os.path.splitext(path)[1].lower()


def is_folder(path: str) -> bool:
    """Whether there is a folder of that path."""
    return os.path.isdir(path)


def is_file(path: str) -> bool:
    """Whether there is a file of that path."""
    return os.path.isfile(path)


def exists(path: str) -> bool:
    """Whether there is anything of that path."""
    return os.path.exists(path)


def size(path: str) -> int:
    """How many bytes a file has; none if it cannot be asked."""
    try:
        return os.path.getsize(path)
    except OSError:
        return 0


def data(path: str) -> bytes:
    """The bytes of a file; OSError if it cannot be read, or if it is a pipe that lies about: whether anybody writes into it is not known.

    What the shell gives by name, `/dev/stdin` or `/dev/fd/63` of `<(...)`, has a writer.
    """
    if "\0" in path:
        raise OSError(ENOENT, "no file has a NUL in its name")
    if stat.S_ISFIFO(os.stat(path).st_mode) and not path.startswith(("/dev/", "/proc/")):
        raise OSError(ENOTSUP, "a named pipe, which may never end; write its content into standard input and name `-`")
    with open(path, "rb") as file:
        return bounded(file)


def bounded(file: BinaryIO) -> bytes:
    """All bytes of an open file; OSError if it is a device that gives more than any program has."""
    try:
        mode = os.fstat(file.fileno()).st_mode
    except OSError:
        return file.read()  # It is no file of the system's, so it is in memory.
    if not (stat.S_ISCHR(mode) or stat.S_ISBLK(mode)):
        return file.read()
    found = file.read(MOST + 1)
    if len(found) > MOST:
        raise OSError(EFBIG, f"a device that gives more than {MOST:,} bytes, which is no program")
    return found


def names(folder: str) -> list[str]:
    """The names in a folder, in order; OSError if it cannot be read."""
    return sorted(os.listdir(folder))


def working_folder() -> str:
    """The working folder."""
    return os.getcwd().replace(os.sep, "/")
