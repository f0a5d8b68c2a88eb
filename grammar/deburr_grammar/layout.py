"""How lines of a dialect may be laid out: which blanks mean nothing, and how they are written by convention. Never touches a line itself."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Any, NamedTuple

from deburr_grammar.tree import Node, Token


class Gap(Enum):
    """What becomes of the blanks between two tokens."""

    KEEP = "left as they are: they are printed, or belong to a text"
    NONE = "no blank"
    ONE = "one blank"
    SOME = "one blank where there is none; more may align something"
    FEW = "one blank at the most"
    EVEN = "one blank where any of the gaps of a chain of operators has blanks, otherwise none"
    ASIDE = "as many as keep what follows in its column, one at least"


class Case(Enum):
    """In which letters the manual writes a token, where the control takes both."""

    ANY = "as it is"
    UPPER = "capital letters"
    LOWER = "small letters"


class Between(NamedTuple):
    """A place between two tokens in the text of a shape; ``around``: the nodes that hold both, the outermost first."""

    text: str
    around: tuple[Node, ...]
    left: Token
    right: Token

    @property
    def node(self) -> Node:
        """The innermost node that holds both."""
        return self.around[-1]


def _kept(between: Between) -> Gap:
    return Gap.KEEP


def _any(node: Node, token: Token) -> Case:
    return Case.ANY


@dataclass(frozen=True)
class Layout:
    """What a formatter may do with the lines of a dialect; without choices of its own nothing.

    All of it must hold on a line's shape alone, and none of it may change what a control
    prints or a flat program holds, the order of tokens, or what is inside of one.
    """

    gap: Callable[[Between], Gap] = _kept
    case: Callable[[Node, Token], Case] = _any
    """For a token and the node that it is a direct part of."""
    indented: frozenset[str] = frozenset()
    """A line that holds one of these kinds of node or token is indented as deep as it stands in blocks."""
    trimmed: frozenset[str] = frozenset()
    """A line that holds one of these loses the blanks at its end."""
    empties: bool = False
    """Whether a line of blanks may be emptied."""
    inside: Callable[[Any], int] = lambda state: 0
    """How many levels the outline's state adds to those of the open blocks, for regions whose lines are indented."""
    parted: frozenset[str] = frozenset()
    """Kinds of blocks with parts: what stands directly in them is written under their openers."""
    longest: int | None = None
    """Bytes that a line may have on the control: no line is made longer than that."""


UNTOUCHED = Layout()
"""No line is laid out."""
