"""The programs that calls lead to: sections of the file itself, programs in a folder, files of L254 (spec/z32.md §6.4)."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

from deburr.analysis import Analysis
from deburr.includes.z32 import found_files, own_files
from deburr.rule import Line
from deburr.rules.z32._fields import certain
from deburr.rules.z32._program import beside, called, lines, numbers_of
from deburr_grammar.dialects.z32.forms import section_number
from deburr_grammar.document import Document
from deburr_grammar.line import LineNode
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

LARGEST = 4_000_000
"""Characters of a file beyond which it is not looked into."""


class Program(NamedTuple):
    """A program that can be called, or the main one: the lines of a file from ``first`` to before ``last``."""

    analysis: Analysis
    first: int
    last: int

    @property
    def file(self) -> str:
        """The path of its file."""
        return self.analysis.file


class Call(NamedTuple):
    """A GOP, GOS or L254: the file and line where it stands, the columns of what it calls, and its text."""

    file: str
    line: int
    span: Span
    said: str


def calls(program: Program) -> Iterator[tuple[int, LineNode, Node]]:
    """All calls of a program."""
    for at, node in lines(program.analysis, "call", "file_call"):
        if program.first <= at < program.last:
            yield from ((at, node, call) for call in node.find("call", "file_call"))


def main_part(analysis: Analysis) -> Program:
    """The file as the operator starts it: it runs through the starts of sections."""
    return Program(analysis, 0, analysis.document.line_count)


def all_sections(analysis: Analysis) -> list[Program]:
    """The sections of a file, each to the start of the next one."""
    bounds = [*numbers_of(analysis, "section"), analysis.document.line_count]
    return [Program(analysis, first, behind) for first, behind in pairwise(bounds)]


def sure_call(program: Program) -> tuple[Call, LineNode, Node] | None:
    """The first call of a program, if nothing before it can jump, end the program, or make the call a condition's."""
    turns = numbers_of(program.analysis, "jump", "call", "file_call", "M_END", "G26")
    index = bisect_left(turns, program.first)
    if index == len(turns) or turns[index] >= program.last:
        return None
    node = program.analysis.document.node(turns[index])
    field = next((certain(advanced) for advanced in node.find("advanced")), None)
    if field is None or field.kind not in ("call", "file_call") or "DELETE" in node.kinds:
        return None
    part = field.children[1]
    said = node.text[field.start : field.end]
    return Call(program.file, turns[index], Span(part.start, part.end), said), node, field


class Programs:
    """What is called from one program and from all that it calls; each file is read at most once. Make it with `programs_of`."""

    def __init__(self, root: Analysis) -> None:
        self._root = root
        self._files: dict[str, Analysis | None] = {root.file: root}

    def called(self, analysis: Analysis, node: LineNode, call: Node) -> Program | None:
        """The program that a call runs; None where the text does not decide it, or there is none."""
        settings = self._root.settings
        if call.kind == "file_call":
            said = node.text[call.children[1].start : call.children[1].end]
            root = str(settings["file-root"])
            paths = found_files(self._root.host, beside(self._root, root), said) if root and ".." not in said else []
            return self._whole(paths[0]) if len(paths) == 1 else None
        number = called(Line(node, settings), call)
        if number is None:
            return None
        folder = str(settings["cmos-dir"])
        if not folder:
            return _section(analysis, number)
        return self._stored(beside(self._root, f"{folder}-temp" if call.children[0].kind == "GOS" else folder), number)

    def _stored(self, folder: str, number: int) -> Program | None:
        """Program n of a folder: a file of that name, else the section of that number, if there is only one."""
        own = own_files(self._root.host, folder, number)
        if own:
            return self._whole(own[0]) if len(own) == 1 else None
        names = self._root.host.names(folder)
        sections = [_section(file, number) for name in names if (file := self._analysis(f"{folder}/{name}"))]
        found = [section for section in sections if section is not None]
        return found[0] if len(found) == 1 else None

    def _whole(self, path: str) -> Program | None:
        """All of a file that is not parted into sections."""
        analysis = self._analysis(path)
        if analysis is None or next(lines(analysis, "section"), None) is not None:
            return None
        return main_part(analysis)

    def _analysis(self, path: str) -> Analysis | None:
        if path not in self._files:
            root, text = self._root, self._root.host.read(path)
            read = text is not None and len(text) <= LARGEST
            self._files[path] = root.nested(Document.parse(text or "", root.dialect), path) if read else None
        return self._files[path]


def programs_of(analysis: Analysis) -> Programs:
    """The programs around a program."""
    if "z32 programs" not in analysis.memo:
        analysis.memo["z32 programs"] = Programs(analysis)
    found: Programs = analysis.memo["z32 programs"]
    return found


def _section(analysis: Analysis, number: int) -> Program | None:
    """The section of a file that has that number, if it is the only one."""
    if "z32 sections" not in analysis.memo:
        known = analysis.memo["z32 sections"] = {}
        for program in all_sections(analysis):
            known.setdefault(section_number(analysis.document.line(program.first)), []).append(program)
    found: list[Program] = analysis.memo["z32 sections"].get(number, [])
    return found[0] if len(found) == 1 else None
