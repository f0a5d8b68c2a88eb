"""The standard streams as a process meets them: closed before it starts, on a full disk, left by their reader. Knows no command."""

import io
import os
import sys
from contextlib import suppress
from errno import EBADF
from typing import Any, TextIO

_NAMES = ("stdin", "stdout", "stderr")


class Patient(io.RawIOBase):
    """Where a stream writes to. Once that fails the rest goes nowhere and ``error`` says why, so that a command does its work to its end."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._raw: Any = getattr(stream.buffer, "raw", stream.buffer)
        self.error: OSError | None = None

    def writable(self) -> bool:
        """Always."""
        return True

    def fileno(self) -> int:
        """That of the stream."""
        return self._stream.fileno()

    def isatty(self) -> bool:
        """Whether the stream is a terminal."""
        return self._stream.isatty()

    def write(self, data: Any) -> int:
        """Some of the bytes; all of them if nobody can have them any more."""
        if self.error is None:
            try:
                return self._written(data)
            except OSError as error:
                self.error = error
        return len(data)

    def _written(self, data: Any) -> int:
        # A pipe that is shared with others may have been told not to wait; where nothing fits in, that is not an end.
        while (count := self._raw.write(data)) is None:
            from select import select

            select([], [self], [])
        return int(count)


class _Closed(io.RawIOBase):
    """Standard input that was closed: not an empty program."""

    def readable(self) -> bool:
        return True

    def readinto(self, _buffer: Any) -> int:
        raise OSError(EBADF, "standard input is closed")


def prepare() -> None:
    """Make the streams of this process patient. One that is closed is as the null device, but that there is nothing to be read."""
    closed = [name for name in _NAMES if getattr(sys, name) is None]
    for name in closed:
        # Else the next file that is opened would be taken for this stream by whoever writes to it by its number.
        number = os.open(os.devnull, os.O_RDWR)
        if name == "stdin":
            sys.stdin = io.TextIOWrapper(io.BufferedReader(_Closed()))
        else:
            nowhere = io.BufferedWriter(io.FileIO(number, "w", closefd=False))
            setattr(sys, name, io.TextIOWrapper(nowhere, errors="backslashreplace"))
    sys.stdout, sys.stderr = _patient(sys.stdout), _patient(sys.stderr)


def gone(stream: TextIO) -> bool:
    """Whether what is written to a stream reaches nobody any more."""
    return _error(stream) is not None


def failure() -> str:
    """Why something that was said is lost; "" if nothing is, or if its reader wanted no more."""
    for name, stream in (("standard output", sys.stdout), ("standard error", sys.stderr)):
        with suppress(OSError):
            stream.flush()
        error = _error(stream)
        if error is not None and not isinstance(error, BrokenPipeError):
            return f"{name}: {error.strerror or error}"
    return ""


def _error(stream: TextIO) -> OSError | None:
    raw = getattr(getattr(stream, "buffer", None), "raw", None)
    return raw.error if isinstance(raw, Patient) else None


def _patient(stream: TextIO) -> TextIO:
    buffer = io.BufferedWriter(Patient(stream))
    return io.TextIOWrapper(
        buffer, stream.encoding, stream.errors, line_buffering=stream.isatty() or stream is sys.stderr
    )
