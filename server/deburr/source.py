"""Bytes to text and nothing lost: encodings, byte order marks, the padding of tapes. Never looks at what the text means."""

from collections.abc import Iterator
from typing import NamedTuple

from deburr.rule import Notice
from deburr_grammar.text import Span, split_lines

PADDING = "nul-bytes"
MARK = "byte-order-mark"
_MARK = "\ufeff"
_BOM = _MARK.encode()
_WIDE = (b"\xff\xfe", b"\xfe\xff")


class Source(NamedTuple):
    """A program as text. ``lead`` and ``tail`` are the NULs and the final ^Z around it, which tapes and transfers leave; ``bom``: whether a byte order mark stood first."""

    text: str
    lead: str = ""
    tail: str = ""
    encoding: str = "utf-8"
    bom: bool = False

    @property
    def lines(self) -> list[str]:
        """The lines as an editor shows them: padding counts, a byte order mark does not."""
        return split_lines(self.lead + self.text + self.tail)

    @property
    def shift(self) -> int:
        """How many columns the first line of the text stands to the right of where it stands in the file."""
        return len(self.lead)

    @property
    def whole(self) -> str:
        """All characters of the file: its mark, its padding and its text."""
        return f"{_MARK if self.bom else ''}{self.lead}{self.text}{self.tail}"

    @property
    def data(self) -> bytes:
        """The bytes of the file."""
        mark = _BOM if self.bom else b""  # Also before text that is not UTF-8.
        return mark + f"{self.lead}{self.text}{self.tail}".encode(self.encoding)

    def notices(self) -> Iterator[Notice]:
        """What is to be said of the mark and the padding, in columns of the text: what leads it stands left of column 0."""
        if self.bom and self.lines != [""]:
            # The mark has no column of its own: the first character that an editor shows stands for it.
            yield Notice(MARK, 0, Span(-len(self.lead), 1 - len(self.lead)), "byte order mark")
        if self.lead:
            yield Notice(PADDING, 0, Span(-len(self.lead), 0), _said(self.lead))
        if self.tail:
            last = split_lines(self.text)
            col = len(last[-1])
            yield Notice(PADDING, len(last) - 1, Span(col, col + len(self.tail)), _said(self.tail))


class NotAProgram(NamedTuple):
    """Bytes that no control takes for a program, and why."""

    reason: str


def read(data: bytes) -> Source | NotAProgram:
    """The program in the bytes. Decoding itself never fails."""
    if data.startswith(_WIDE):
        return NotAProgram("this is UTF-16, not a program that a control reads; save it as UTF-8")
    bom = data.startswith(_BOM)
    body = data[len(_BOM) :] if bom else data
    start = len(body) - len(body.lstrip(b"\0"))
    end = max(start, len(body.rstrip(b"\0\x1a")))
    at = body.find(b"\0", start, end)
    if at >= 0:
        return NotAProgram(f"a NUL byte at offset {at + len(data) - len(body)}: this is no program")
    text, encoding = decoded(body[start:end])
    return Source(text, "\0" * start, body[end:].decode("ascii"), encoding, bom)


def text(data: bytes) -> str:
    """The text of a file that a program names, whatever it holds."""
    found = read(data)
    return found.text if isinstance(found, Source) else decoded(data)[0]


def decoded(data: bytes) -> tuple[str, str]:
    """The text and the encoding that it is in: UTF-8, else cp1252, else latin-1, in which all bytes mean something."""
    for encoding in ("utf-8", "cp1252"):
        try:
            return data.decode(encoding), encoding
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1"), "latin-1"


def eol_of(text: str) -> str:
    """The line end of a text: its first one."""
    at = min((place for place in (text.find("\n"), text.find("\r")) if place >= 0), default=-1)
    return "\n" if at < 0 else "\r\n" if text.startswith("\r\n", at) else text[at]


def _said(padding: str) -> str:
    count = padding.count("\0")
    said = [f"{count} NUL byte{'s' if count > 1 else ''}"] if count else []
    said += ["the end mark ^Z"] if len(padding) > count else []
    return " and ".join(said)
