"""A text as a client has it and edits it, in the plainest way there is: bytes of the encoding."""

from __future__ import annotations

import re
from typing import Any

from deburr_grammar.text import Edit, Pos

ENCODINGS = {"utf-8": "utf-8", "utf-16": "utf-16-le", "utf-32": "utf-32-le"}
UNIT = {"utf-8": 1, "utf-16": 2, "utf-32": 4}
_EOL = re.compile(r"\r\n|\n|\r")


class Model:
    """A text as a client has it, in the plainest way there is: bytes of the encoding."""

    def __init__(self, text: str, encoding: str) -> None:
        self.text = text
        self._encoding = encoding

    def change(self, edit: Edit) -> dict[str, Any]:
        """Make an edit whose columns are units; the change that the server is sent."""
        start, end = self._at(edit.start), self._at(edit.end)
        if end < start:
            start, end, edit = end, start, Edit(edit.end, edit.start, edit.text)
        self.text = self.text[:start] + edit.text + self.text[end:]
        said = [{"line": pos.line, "character": pos.col} for pos in (edit.start, edit.end)]
        return {"range": {"start": said[0], "end": said[1]}, "text": edit.text}

    def _at(self, pos: Pos) -> int:
        """The offset of a place; in the middle of a character its start."""
        starts = [0, *(match.end() for match in _EOL.finditer(self.text))]
        if pos.line >= len(starts):
            return len(self.text)
        line = _EOL.split(self.text[starts[pos.line] :], maxsplit=1)[0]
        wire, unit = ENCODINGS[self._encoding], UNIT[self._encoding]
        data = line.encode(wire, "surrogatepass")[: pos.col * unit]
        return starts[pos.line] + len(data.decode(wire, "ignore"))
