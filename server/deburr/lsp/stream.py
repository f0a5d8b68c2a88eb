"""Messages on streams of bytes: `Content-Length` headers, standard input and output, TCP. Never looks into a message."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from typing import Protocol

_LENGTH = re.compile(rb"(?im)^content-length:[ \t]*([0-9]+)[ \t]*\r?$")
_CHUNK = 1 << 20


class Stream(Protocol):
    """Where messages come from and go to."""

    def receive(self) -> bytes:
        """Some bytes, as soon as there are any; none at the end."""

    def write(self, data: bytes) -> None:
        """All of the bytes; BrokenPipeError if nobody reads them any more."""

    def close(self) -> None:
        """Nothing more is written."""


class Frames:
    """Cuts a stream into message bodies."""

    def __init__(self) -> None:
        self._rest = bytearray()
        self._wanted = -1

    def feed(self, data: bytes) -> Iterator[bytes]:
        """The bodies that are complete with these bytes. A header without a length is passed over."""
        self._rest += data
        while True:
            if self._wanted < 0:
                at = self._rest.find(b"\r\n\r\n")
                if at < 0:
                    return
                length = _LENGTH.search(self._rest, 0, at)
                self._wanted = int(length[1]) if length else 0
                del self._rest[: at + 4]
            if len(self._rest) < self._wanted:
                return
            body = bytes(self._rest[: self._wanted])
            del self._rest[: self._wanted]
            self._wanted = -1
            if body:
                yield body


def framed(body: bytes) -> bytes:
    """A body with its header."""
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


class Stdio:
    """Standard input and output. Whatever else is printed goes to standard error, so that it cannot get between messages."""

    def __init__(self) -> None:
        self._in, self._out = os.dup(0), os.dup(1)
        for descriptor in (self._in, self._out):
            _binary(descriptor)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        os.dup2(2, 1)

    def receive(self) -> bytes:
        """Some bytes."""
        return os.read(self._in, _CHUNK)

    def write(self, data: bytes) -> None:
        """All of the bytes."""
        rest = memoryview(data)
        try:
            while rest:
                rest = rest[os.write(self._out, rest) :]
        except OSError as error:
            raise BrokenPipeError from error

    def close(self) -> None:
        """Close standard output."""
        os.close(self._out)


class Tcp:
    """The first client that connects to an address. Which port was taken, if it was left open with 0, is said on standard error."""

    def __init__(self, host: str, port: int) -> None:
        import socket

        with socket.create_server((host, port)) as listener:
            address, number = listener.getsockname()[:2]
            sys.stderr.write(f"deburr: listening on {host}:{number}\n")
            if not _is_loopback(address):
                sys.stderr.write(
                    f"deburr: warning: {host} can be reached from other machines, and whoever connects first can read"
                    f" what you can read; 127.0.0.1:{number} is for this machine only\n"
                )
            sys.stderr.flush()
            self._socket, _ = listener.accept()
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def receive(self) -> bytes:
        """Some bytes; none as well if the other side broke off."""
        try:
            return self._socket.recv(_CHUNK)
        except OSError:
            return b""

    def write(self, data: bytes) -> None:
        """All of the bytes."""
        try:
            self._socket.sendall(data)
        except OSError as error:
            raise BrokenPipeError from error

    def close(self) -> None:
        """Close the connection."""
        self._socket.close()


def _binary(descriptor: int) -> None:
    """No line endings are to be changed, as Windows does unless told otherwise."""
    if sys.platform == "win32":
        import msvcrt

        msvcrt.setmode(descriptor, os.O_BINARY)


def _is_loopback(address: str) -> bool:
    """Whether only this machine can reach an address."""
    from ipaddress import ip_address

    return ip_address(address).is_loopback
