"""The files of a Z32 program and where its calls lead: sections of the calling file, programs in a folder, files of L254 (spec/z32.md §6.4, §11). Enters none."""

from __future__ import annotations

from collections import Counter, OrderedDict
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from deburr.arithmetic.z32 import constant, integer
from deburr.includes.z32 import beside, found_files, own_files
from deburr.values.z32.lines import Marks, marks_of
from deburr_grammar.dialects.z32.forms import parts, section_number
from deburr_grammar.document import Document

if TYPE_CHECKING:
    from deburr.analysis import Analysis
    from deburr_grammar.dialect import Dialect, Reading
    from deburr_grammar.line import LineNode, Shape
    from deburr_grammar.tree import Node

_LARGEST = 4_000_000
"""Characters of a file beyond which it is not looked into."""
_KEPT = 100
_documents: OrderedDict[tuple[str, str], Document] = OrderedDict()


class Target(NamedTuple):
    """What a call leads to: a file, or one of its sections."""

    path: str
    section: int | None


class File:
    """A file with what its lines say together."""

    def __init__(self, path: str, document: Document) -> None:
        self.path = path
        self.document = document
        self.marks: Marks = marks_of(document)

    @cached_property
    def sections(self) -> Sequence[int]:
        """The numbers of its sections; those that are there twice are none, because the control may run either."""
        numbers = Counter(section_number(self.document.line(row)) for row in rows_with(self.document, "section"))
        return [number for number, times in numbers.items() if times == 1 and number is not None]


class Files:
    """The files of one program; each is read when it is first needed."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        self.main = File(analysis.file, analysis.document)
        self._files: dict[str, File | None] = {analysis.file: self.main}
        self._folder = str(analysis.settings["cmos-dir"])
        self._root = str(analysis.settings["file-root"])

    def all(self) -> Iterator[File]:
        """The program's own file and all that calls lead to."""
        waiting, seen = [self.main], {self.main.path}
        while waiting:
            file = waiting.pop()
            yield file
            for target in self._targets(file) if self._folder or self._root else ():
                called = self.file(target.path)
                if called is not None and called.path not in seen:
                    seen.add(called.path)
                    waiting.append(called)

    def file(self, path: str) -> File | None:
        """The file of a path; None if it cannot be read."""
        if path not in self._files:
            text = self._analysis.host.read(path)
            known = text is not None and len(text) <= _LARGEST
            self._files[path] = File(path, _parsed(text or "", self._analysis.document.dialect)) if known else None
        return self._files[path]

    def target(self, file: File, node: LineNode, call: Node) -> Target | None:
        """What a call in a file leads to; None where only the run knows, or nothing is there."""
        part = call.children[1]
        if call.kind == "file_call":
            return self._below_root(node.text[part.start : part.end])
        value = constant(node.text, part)
        number = integer(value) if isinstance(value, float) else None
        if number is None:
            return None
        if not self._folder:
            return Target(file.path, number) if number in file.sections else None
        temporary = "-temp" if call.children[0].kind == "GOS" else ""
        return self._stored(beside(self.main.path, self._folder + temporary), number)

    def _targets(self, file: File) -> Iterator[Target]:
        for row in rows_with(file.document, "call", "file_call"):
            node = file.document.node(row)
            found = (self.target(file, node, call) for call in node.find("call", "file_call"))
            yield from (target for target in found if target is not None)

    def _stored(self, folder: str, number: int) -> Target | None:
        host = self._analysis.host
        own = own_files(host, folder, number)
        if own:
            found = [Target(path, None) for path in own if self.file(path) is not None]
        else:
            files = [self.file(f"{folder}/{name}") for name in host.names(folder)]
            found = [Target(file.path, number) for file in files if file is not None and number in file.sections]
        return found[0] if len(found) == 1 else None

    def _below_root(self, said: str) -> Target | None:
        inner = parts(said)
        if not self._root or ".." in inner or not inner:
            return None
        paths = found_files(self._analysis.host, beside(self.main.path, self._root), "/".join(inner))
        same = [path for path in paths if path.rpartition("/")[2].upper() == inner[-1].upper()]
        found = same if len(same) == 1 else paths
        return Target(found[0], None) if len(found) == 1 and self.file(found[0]) is not None else None


def rows_with(document: Document, *kinds: str) -> Iterator[int]:
    """The lines that hold one of some kinds of parts."""

    def says(reading: Reading, shape: Shape) -> bool:
        return reading.start is not None and not shape.facts(reading).kinds.isdisjoint(kinds)

    return (piece.line + at for piece in document.pieces() for at, _, _ in piece.where(says))


def _parsed(text: str, dialect: Dialect) -> Document:
    key = (dialect.name, text)
    found = _documents.get(key)
    if found is None:
        found = _documents[key] = Document.parse(text.removeprefix("\ufeff"), dialect)
        while len(_documents) > _KEPT:
            _documents.popitem(last=False)
    _documents.move_to_end(key)
    return found
