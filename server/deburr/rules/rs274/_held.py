"""What single lines say of parameters, calls and program ends: gathered once a chunk and kept with it. Never looks beyond a line."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator, Mapping
from enum import Enum
from functools import lru_cache
from typing import Any, NamedTuple

from deburr.rule import Line
from deburr.rules.rs274._values import NEAR, index, name
from deburr_grammar.dialect import Reading
from deburr_grammar.dialects.rs274.outline import codes, ends, label_of
from deburr_grammar.document import Document, Piece
from deburr_grammar.line import LineNode, Shape
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token

_PARTS = frozenset(("param", "CALL", "PERCENT"))
_CALLING = re.compile(r"[Mm][ \t]*0*[ \t]*9[ \t]*8(?![0-9])|[Gg][ \t]*0*[ \t]*7[ \t]*[0-2](?![0-9])")
_CONTOURS = frozenset(("G70", "G71", "G71.1", "G71.2", "G72", "G72.1", "G72.2"))
_MENTIONED = re.compile(r"#[ \t]*(?:<([^<>]*)>|([0-9]+))")
_BLANKS = re.compile(r"[ \t]+")


class Role(Enum):
    """What a line does with a parameter."""

    READ = "reads it"
    SET = "sets it"
    ASKED = "asks by EXISTS whether there is one"
    MENTIONED = "names it in a line that cannot be read, so that nothing is certain of it"


class Use(NamedTuple):
    """A parameter in a line: a ``name`` as the control compares it, or a ``number``; neither if only the run knows which.

    ``extent``: of one that is set the whole setting, otherwise the parameter itself.
    """

    line: int
    span: Span
    name: str | None
    number: int | None
    role: Role
    extent: Span


class Call(NamedTuple):
    """A call: ``label`` is the sub's, ``path`` the label with the folder that may stand before it; None: only the run knows.

    A cycle that follows a contour calls the sub of its Q word. ``fanuc``: an `M98`, which goes to a bare O-word. ``faulty``: the line cannot be read to its end.
    """

    line: int
    span: Span
    label: str | None
    path: str | None
    fanuc: bool
    faulty: bool


class Held(NamedTuple):
    """What is in some lines, in order: ``ends`` are those of M2 and M30, ``bare`` those of O-words without a command."""

    uses: list[Use]
    calls: list[Call]
    ends: list[int]
    percents: list[int]
    bare: list[tuple[int, str | None]]


def holding(document: Document, settings: Mapping[str, Any]) -> Generator[None, None, Held]:
    """What is in the whole program, found in steps."""
    found = Held([], [], [], [], [])
    uses = found.uses
    for piece in document.pieces():
        for line, part in _of_piece(document, piece, settings["compare"]):
            at = piece.line + line
            for _, span, named, number, role, extent in part.uses:
                uses.append(Use(at, span, named, number, role, extent))
            if part.calls:
                found.calls.extend([call._replace(line=at) for call in part.calls])
            if part.ends:
                found.ends.extend([at] * len(part.ends))
            if part.percents:
                found.percents.extend([at] * len(part.percents))
            if part.bare:
                found.bare.extend([(at, label) for _, label in part.bare])
        yield
    return found


def _of_piece(document: Document, piece: Piece, compare: str) -> list[tuple[int, Held]]:
    """What the lines of a chunk hold that hold anything; kept with the chunk."""
    key = ("rs274 held", document.key(piece), compare)
    found: list[tuple[int, Held]] | None = piece.chunk.memo.get(key)
    if found is None:
        found = piece.chunk.memo[key] = [
            (at, _of_line(piece.chunk.line(at), reading, shape, compare)) for at, reading, shape in piece.where(_says)
        ]
    return found


@lru_cache(maxsize=4_096)
def _of_line(text: str, reading: Reading, shape: Shape, compare: str) -> Held:
    """What a line holds, as line 0. Many lines of a program are written more than once."""
    found = Held([], [], [], [], [])
    _take(found, 0, Line(LineNode(text, reading, shape), {"compare": compare}))
    return found


def _says(reading: Reading, shape: Shape) -> bool:
    """Whether lines of a shape can say anything that is gathered; kept with the shape."""
    if reading.start is None:
        return False
    key = ("rs274 held", reading.name)
    if key not in shape.memo:
        facts = shape.facts(reading)
        shape.memo[key] = (
            not facts.kinds.isdisjoint(_PARTS)
            or ("#" in shape.text and bool(facts.problems))
            or shape.needs_depth
            or ("word" in facts.kinds and _CALLING.search(shape.text) is not None)
            or any(True for _ in _bare(LineNode(shape.text, reading, shape)))
        )
    return bool(shape.memo[key])


def _take(found: Held, at: int, line: Line) -> None:
    node = line.node
    found.uses.extend(_uses(at, line))
    found.calls.extend(_calls(at, line))
    if "PERCENT" in node.kinds and not node.problems:
        found.percents.append(at)
    if node.shape.needs_depth and "DELETE" not in node.kinds and ends({code for code, _ in codes(node)}):
        found.ends.append(at)
    found.bare.extend((at, _label(node, label)) for label in _bare(node))


def _bare(node: LineNode) -> Iterator[Node]:
    """The labels of O-words without a command."""
    for o_line in node.find("o_line") if not node.problems else ():
        label = o_line.children[1]
        if isinstance(label, Node) and all(part.kind == "COMMENT" for part in o_line.children[2:]):
            yield label


def _uses(at: int, line: Line) -> Iterator[Use]:
    parts = list(line.node.find("setting", "param", "exists"))
    targets = {part.start: part for part in parts if part.kind == "setting"}
    asked = [(part.start, part.end) for part in parts if part.kind == "exists"]
    for param in parts:
        if param.kind != "param" or len(param.children) < 2:
            continue
        setting = targets.get(param.start)
        role = Role.SET if setting else Role.READ
        if line.node.problems:
            role = Role.MENTIONED
        elif any(start <= param.start < end for start, end in asked):
            role = Role.ASKED
        named = name(line, param)
        extent = Span(setting.start, setting.end) if setting else Span(param.start, param.end)
        yield Use(at, Span(param.start, param.end), named, None if named else _number(line, param), role, extent)
    if line.node.problems:
        for match in _MENTIONED.finditer(line.text):
            said, digits = match.groups()
            named = None if said is None else "".join(said.split()).lower()
            number = int(digits) if digits and len(digits) < 9 else None
            yield Use(at, Span(*match.span()), named, number, Role.MENTIONED, Span(*match.span()))


def _number(line: Line, param: Node) -> int | None:
    value = index(line, param)
    return round(value) if value is not None and abs(value - round(value)) <= NEAR else None


def _calls(at: int, line: Line) -> Iterator[Call]:
    node = line.node
    if "CALL" in node.kinds:
        o_line = next(node.find("o_line"), node.tree)
        label, command = o_line.node("label"), o_line.find("CALL")
        if label is not None and command is not None:
            path = _label(node, label)
            only = path.rpartition("/")[2] if path is not None else None
            yield Call(
                at, Span(label.start - _letter(o_line, label), command.end), only, path, False, bool(node.problems)
            )
        return
    if not _CALLING.search(node.shape.text):
        return
    for code, word in codes(node):
        if code == "M98" or code in _CONTOURS:
            yield from _by_number(at, line, word, "p" if code == "M98" else "q")


def _by_number(at: int, line: Line, code: Node, letter: str) -> Iterator[Call]:
    """A call by a code with the label in another word; none without that word."""
    for word in line.node.find("word"):
        if line.text[word.start].lower() == letter:
            said = _literal(line, word)
            span = Span(min(code.start, word.start), max(code.end, word.end))
            yield Call(at, span, said, said, letter == "p", bool(line.node.problems))
            return


def _literal(line: Line, word: Node) -> str | None:
    """The label that a word's written-out number means; None where only the run knows it."""
    value = word.children[-1]
    if not isinstance(value, Token) or value.kind != "NUMBER":
        return None
    digits = _BLANKS.sub("", line.text[value.start : value.end])
    return (digits.lstrip("0") or "0") if digits.isdigit() else None


def _letter(o_line: Node, label: Node) -> int:
    """How far before its label the O stands."""
    letter = o_line.find("O")
    return label.start - letter.start if letter is not None else 0


def _label(node: LineNode, label: Node) -> str | None:
    """The label as the control compares it; None too for a number that is no integer, which no sub can have."""
    found = label_of(node.text, label)
    number = label.children[0].kind == "NUMBER"
    return None if found is None or (number and not found.isdigit()) else found
