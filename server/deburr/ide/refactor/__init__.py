"""What a language's programs can be rebuilt by: numbers of lines and blocks, constants, parts of their own. Languages are modules named after their dialects."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, NamedTuple, Protocol, TypeVar

if TYPE_CHECKING:
    from deburr.ide.view import View
    from deburr.symbols import Mention
    from deburr.symbols.index import Placed
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode
    from deburr_grammar.text import Span


T = TypeVar("T")
Work = Generator[None, None, T]
"""What comes to a result in steps, between which it can be left."""


class Cannot(Exception):
    """Why a program cannot be rebuilt like that."""


class Numbering(NamedTuple):
    """How something is numbered: the first number, the step, and the largest that the control takes."""

    first: int
    step: int
    largest: int


class Constant(NamedTuple):
    """A setting of a variable to a number: the number, the stretch of the line that is the setting, and whether the setting may go when nothing uses it."""

    value: str
    span: Span
    goes: bool


class NewFile(NamedTuple):
    """A file that is not there yet."""

    file: str
    text: str


class Extraction(NamedTuple):
    """Lines as a part of their own: what stands in their place, and either a file, or lines that go before another line."""

    call: str
    line: int = 0
    lines: Sequence[str] = ()
    file: NewFile | None = None


class Moves(Protocol):
    """What a dialect's module knows; a numbering of None: there is nothing of the sort."""

    LINES: Numbering | None
    BLOCKS: Numbering | None
    EXTRACTED: str
    """What lines become that are extracted."""
    IN_ORDER: bool
    """Whether lines run from the first on, so that what is set above is set before; otherwise only what is proven of values says so."""
    MISSING: tuple[str, ...]
    """The rules, without the language, that miss a file."""

    def line_numbers(self, line: LineNode) -> Iterator[Mention]:
        """Numbers of lines where they are defined and where they are jumped to; without a name where only the run knows it."""

    def starts_section(self, line: LineNode) -> bool:
        """Whether line numbers from here on are others than those before."""

    def block_numbers(self, line: LineNode) -> Iterator[Mention]:
        """Numbers of blocks and subprograms; without a name where only the run knows it."""

    def constant(self, line: LineNode, mention: Mention) -> Constant | None:
        """The setting that a mention is, if it is one to a number and runs whenever its line is reached."""

    def undeclared(self, line: LineNode, mention: Mention) -> Span:
        """The stretch of a declaration that declares what a mention defines: all of it, if it declares nothing else."""

    def inlined(self, value: str, line: LineNode, mention: Mention) -> str:
        """A number in the place of a variable; Cannot where it would mean something else."""

    def extracted(self, view: View, first: int, last: int) -> Extraction:
        """Whole lines as a part of their own; Cannot where that would mean something else."""

    def missing(self, view: View, placed: Placed) -> NewFile | None:
        """The file that a name stands for where it stands, with the least that it must hold."""


@cache
def moves_of(dialect: str) -> Moves | None:
    """The module of a dialect; None if it has none."""
    name = f"{__name__}.{dialect}"
    found: Moves | None = import_module(name) if find_spec(name) is not None else None
    return found


def fresh_name(taken: set[str], stem: str) -> str:
    """A name that nothing has yet."""
    number, name = 1, stem
    while name in taken:
        number += 1
        name = f"{stem}{number}"
    return name


def balanced(document: Document, first: int, last: int) -> bool:
    """Whether lines open what they close, name no block around them, and neither start nor end a region."""
    from deburr_grammar.dialect import Role

    open_labels: list[str | None] = []
    for line, bracket in document.brackets():
        if line > last:
            break
        if line < first:
            continue
        if bracket.role in (Role.REGION, Role.END_REGION):
            return False
        if bracket.role is Role.OPEN:
            open_labels.append(bracket.label)
        elif (
            bracket.role is Role.CLOSE
            and (not open_labels or open_labels.pop() != bracket.label)
            or bracket.role is Role.MIDDLE
            and bracket.label not in open_labels
        ):
            return False
    return not open_labels
