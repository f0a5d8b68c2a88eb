"""The bytes that a fuzzer makes, read as choices and texts. Needs no fuzzer, so what one has found can be tried anywhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeVar

T = TypeVar("T")
END = b"\xff"
"""What ends a part. It stands in no UTF-8, so a part that grows moves no other one."""


class Choices:
    """Bytes that are used up from the front; behind their end all are 0."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    def __bool__(self) -> bool:
        return self._at < len(self._data)

    def byte(self) -> int:
        """The next byte."""
        self._at += 1
        return self._data[self._at - 1] if self._at <= len(self._data) else 0

    def pick(self, choices: Sequence[T]) -> T:
        """One of some choices."""
        return choices[self.byte() % len(choices)]

    def part(self) -> bytes:
        """The bytes up to the next end."""
        end = self._data.find(END, self._at)
        end = len(self._data) if end < 0 else end
        start, self._at = self._at, end + 1
        return self._data[start:end]

    def text(self) -> str:
        """A part as text."""
        return self.part().decode("utf-8", "replace")

    def rest(self) -> bytes:
        """All that is left, ends among it."""
        start, self._at = self._at, len(self._data)
        return self._data[start:]


def joined(head: Iterable[int], *parts: str | bytes) -> bytes:
    """Bytes that give these choices and parts."""
    return bytes(head) + END.join(part if isinstance(part, bytes) else part.encode() for part in parts)
