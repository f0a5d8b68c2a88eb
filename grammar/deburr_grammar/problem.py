"""A syntax fault as a value. Never an exception, never a severity: the rule of the same name owns page, severity and words."""

from typing import NamedTuple


class Problem(NamedTuple):
    """Why a line could not be read to its end.

    ``kind`` is a rule name without its dialect (``comment-nested``), ``start`` and ``end``
    are columns, and ``expected`` says in the user's words what could have stood there.
    """

    kind: str
    start: int
    end: int
    expected: tuple[str, ...] = ()


class Part(NamedTuple):
    """Something the parser had read when it stopped: a terminal or a rule, with its columns."""

    kind: str
    start: int
    end: int


class SyntaxFault(NamedTuple):
    """What the parser knows when it stops: the dialect turns this into a Problem.

    ``found`` is the terminal that does not fit ("" where no terminal matches, "$END" at the
    line's end), ``expected`` the terminals that would have, ``stack`` what was read before,
    outermost first, and ``tokens`` the tokens read before.
    """

    text: str
    start: int
    end: int
    found: str
    expected: frozenset[str]
    stack: tuple[Part, ...]
    tokens: tuple[Part, ...]

    @property
    def before(self) -> Part | None:
        """The last token that was read."""
        return self.tokens[-1] if self.tokens else None

    def inside(self, kind: str) -> Part | None:
        """The innermost unfinished part of that kind."""
        return next((part for part in reversed(self.stack) if part.kind == kind), None)
