"""Between the client's units and ours: the only place that counts in UTF-8 or UTF-16. Never looks at what a text means.

A client's position is a line and a number of units of the negotiated encoding; ours is a line
and a column in code points. Past a line's end means that end, and in the middle of a character its start.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import quote, unquote, urlsplit

from lsprotocol import types

from deburr import paths
from deburr.finding import Place
from deburr_grammar.text import Edit, Pos, Span

if TYPE_CHECKING:
    from deburr_grammar.document import Document

Line = Callable[[int], str]
"""The text of a line; "" for one that is not there."""


def _utf8(char: str) -> int:
    return 1 + (char > "\x7f") + (char > "\u07ff") + (char > "\uffff")


def _utf16(char: str) -> int:
    return 1 + (char > "\uffff")


_WIDTHS: dict[str, Callable[[str], int]] = {"utf-8": _utf8, "utf-16": _utf16}


class Units(NamedTuple):
    """The units of one client."""

    encoding: str

    def col_to_units(self, text: str, col: int) -> int:
        """Columns before a place as units."""
        width = None if text.isascii() else _WIDTHS.get(self.encoding)
        if width is None:
            return min(col, len(text))
        return sum(map(width, text[:col]))

    def units_to_col(self, text: str, units: int) -> int:
        """Units before a place as columns."""
        width = None if text.isascii() else _WIDTHS.get(self.encoding)
        if width is None:
            return min(max(units, 0), len(text))
        for col, char in enumerate(text):
            units -= width(char)
            if units < 0:
                return col
        return len(text)

    def pos(self, document: Document, position: types.Position) -> Pos:
        """A client's position in a document."""
        if position.line >= document.line_count:
            return document.offset(Pos(document.line_count, 0))
        return Pos(position.line, self.units_to_col(document.line(position.line), position.character))

    def edit(self, document: Document, change: types.TextDocumentContentChangePartial) -> Edit:
        """A client's change as an edit of a document."""
        start, end = self.pos(document, change.range.start), self.pos(document, change.range.end)
        return Edit(min(start, end), max(start, end), change.text)

    def position(self, line: Line, pos: Pos) -> types.Position:
        """Our position for the client."""
        return types.Position(pos.line, self.col_to_units(line(pos.line), pos.col))

    def range(self, line: Line, number: int, span: Span) -> types.Range:
        """A stretch of one line for the client."""
        return self.place(line, Place("", number, span.start, number, span.end))

    def text_edit(self, line: Line, edit: Edit) -> types.TextEdit:
        """An edit for the client."""
        return types.TextEdit(types.Range(self.position(line, edit.start), self.position(line, edit.end)), edit.text)

    def place(self, line: Line, place: Place) -> types.Range:
        """A stretch of a file for the client."""
        start = self.position(line, Pos(place.line, place.col))
        return types.Range(start, self.position(line, Pos(place.end_line, place.end_col)))


def line_of(document: Document) -> Line:
    """The lines of a document."""
    return lambda line: document.line(line) if 0 <= line < document.line_count else ""


_DRIVE = re.compile(r"/[A-Za-z](?::|%3[Aa])")


def uri_to_file(uri: str) -> str:
    """The path of a `file:` URI with `/` between its parts; any other text is its own name, a URI or none."""
    try:
        parts = urlsplit(uri)
    except ValueError:
        return uri
    if parts.scheme != "file":
        return uri
    path = unquote(parts.path)
    if _DRIVE.match(path):
        path = path[1].upper() + path[2:]
    return paths.absolute(f"//{parts.netloc}{path}" if parts.netloc else path)


def file_to_uri(file: str) -> str:
    """The `file:` URI of a path; what is no absolute path is a URI already."""
    if file.startswith("//"):
        return "file:" + quote(file)
    if file.startswith("/"):
        return "file://" + quote(file)
    if re.match(r"[A-Za-z]:/", file):
        return f"file:///{file[0].lower()}%3A{quote(file[2:])}"
    return file
