"""What a feature sees: one version of a program, and the programs around it. Never opens a file itself."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol

if TYPE_CHECKING:
    from deburr.host import Host
    from deburr.ruleset import RuleSet
    from deburr_grammar.dialect import Dialect
    from deburr_grammar.document import Document
    from deburr_grammar.text import Span


class Around(Protocol):
    """The programs of a session, open ones as they are in the editor."""

    def view(self, file: str, like: View) -> View | None:
        """A file as a program of the language of another one; None if there is no such file."""

    def views(self, like: View) -> Iterable[View]:
        """All programs of the language of one, that one among them."""


@dataclass(frozen=True, eq=False)
class View:
    """A version of a program."""

    file: str
    document: Document
    ruleset: RuleSet
    host: Host
    around: Around
    is_read: bool = True
    """Whether it is known what all its lines name; of a long program that was just opened a question must not read them all."""

    @property
    def dialect(self) -> Dialect:
        """The language of the program."""
        return self.document.dialect

    def beside(self, file: str) -> View | None:
        """Another file as a program of the same language."""
        return self if file == self.file else self.around.view(file, self)

    def all(self) -> Iterable[View]:
        """All programs of the same language, this one among them."""
        return self.around.views(self)


class Spot(NamedTuple):
    """A stretch of a line of a file: 0-based line, columns in code points."""

    file: str
    line: int
    span: Span
