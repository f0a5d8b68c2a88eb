"""The files of subprograms that an RS274 program calls, as its host has them. Opens nothing itself, judges nothing."""

from __future__ import annotations

from collections import OrderedDict
from typing import TYPE_CHECKING, NamedTuple

from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.analysis import Analysis

_KEPT = 100
_documents: OrderedDict[tuple[str, str], Document] = OrderedDict()
"""What files say, by their text."""


class File(NamedTuple):
    """A file and what it says."""

    path: str
    document: Document


class Files:
    """Where the control looks for subprograms: beside the program, then in the folders of `subroutine-path` (spec/oracle.md §1)."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self._folders = (analysis.file.rpartition("/")[0], *analysis.settings["subroutine-path"])

    def has(self, label: str) -> bool:
        """Whether there is a file of a label."""
        return self._text(label) is not None

    def read(self, label: str) -> File | None:
        """The file of a label; None if there is none."""
        found = self._text(label)
        if found is None:
            return None
        path, text = found
        key = (self._analysis.dialect.name, text)
        document = _documents.get(key)
        if document is None:
            document = _documents[key] = Document.parse(text, self._analysis.dialect)
            while len(_documents) > _KEPT:
                _documents.popitem(last=False)
        _documents.move_to_end(key)
        return File(path, document)

    def _text(self, label: str) -> tuple[str, str] | None:
        for folder in self._folders:
            path = f"{folder.rstrip('/')}/{label}.ngc" if folder else f"{label}.ngc"
            text = self._analysis.host.read(path)
            if text is not None:
                return path, text
        return None
