"""What a rule is: a generator with a severity, a trigger and a manual page. One file a rule; its name is its file's.

The module docstring is the page of `deburr rule NAME` and the rule's test: a summary line,
why it matters, `Source:`, and `Bad:` and `Good:` blocks. Never imports a dialect.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar, cast

from deburr.finding import Severity
from deburr.steps import MANY
from deburr_grammar.line import LineNode
from deburr_grammar.problem import Problem
from deburr_grammar.structure import Fault
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

if TYPE_CHECKING:
    from deburr.modal import State

T = TypeVar("T")

__all__ = [
    "Line",
    "Long",
    "Modal",
    "Moved",
    "Nodes",
    "Note",
    "Notice",
    "Noticed",
    "Proven",
    "Ran",
    "Report",
    "Rule",
    "Severity",
    "Structure",
    "Syntax",
    "Text",
    "Whole",
    "covers",
    "expected",
    "parted",
    "rule",
    "whole",
]


class Note(NamedTuple):
    """A related place: its line (0-based), its columns, what it is; ``file`` is None for the program itself."""

    line: int
    span: Span
    message: str
    file: str | None = None


class Report(NamedTuple):
    """What a rule yields: columns and message. ``line`` is only for rules that see more than one line, ``file`` for those that find a fault in another file.

    ``severity``: of this report, where it weighs less than others of its rule; what is configured for the rule still decides.
    """

    span: Span
    message: str
    line: int = -1
    related: tuple[Note, ...] = ()
    file: str | None = None
    severity: Severity | None = None


class Line(NamedTuple):
    """What a rule on lines sees: the line, the dialect's settings and, in rules on texts and lengths, the line's ending. Never where the line stands."""

    node: LineNode
    settings: Mapping[str, Any]
    ending: str = ""

    @property
    def text(self) -> str:
        """The line's text without its ending."""
        return self.node.text

    def said(self, part: Any) -> str:
        """The text of a node, token or problem."""
        return self.node.text[part.start : part.end]


class Syntax(NamedTuple):
    """The rule is called for each Problem of its own name, and for each node of ``kinds`` that can break it though it can be read: `check(line, part)`.

    ``only``: a setting and the value without which no node breaks the rule. Where it has another
    one, lines that can be read cost nothing.
    """

    kinds: tuple[str, ...] = ()
    only: tuple[str, str] | None = None


class Nodes(NamedTuple):
    """The rule is called for each node of these kinds: `check(line, node)`. Lines without one cost nothing.

    ``by_shape``: what the rule says hangs on the line's shape alone, on letters and on the
    codes that the dialect protects, not on other numbers or on comments. It is then asked once
    a shape, and lines of a shape of which it says nothing cost nothing either.
    ``where``: for rules on numbers, asked once a shape, whether any lines of it may break the rule:
    that there is a sign or a point before or in a number can be seen, its value cannot.
    """

    kinds: tuple[str, ...]
    by_shape: bool = False
    where: Callable[[Line, Node], bool] | None = None


class Modal(NamedTuple):
    """The rule is called for each line that has a node of these kinds, with the modal state before it: `check(line, state)`.

    Whether it says anything of a line must hang on the line's shape and on the state alone; it is
    asked once for each pair of them. Where runs may differ the state is unknown (deburr/modal.py).
    ``where``: as in `Nodes`, whether any lines of a shape may break the rule under a state.
    """

    kinds: tuple[str, ...]
    where: Callable[[Line, State], bool] | None = None


class Text(NamedTuple):
    """The rule is called for each line in whose text the pattern is found: `check(line)`. The pattern must not match a line end.

    ``signs``: characters with one of which every match starts. To find a sign costs much less than to try a pattern everywhere.
    """

    pattern: str
    signs: str = ""


class Long(NamedTuple):
    """The rule is called for each line of more than that many characters: `check(line)`."""

    characters: int


class Structure(NamedTuple):
    """The rule is called for each structure fault of these sorts: `check(fault)`; reports must name a line."""

    faults: tuple[Fault, ...]


class Whole(NamedTuple):
    """The rule is called once: `check(analysis)`; reports must name a line, and between them it may yield None where its work can be left.

    What goes through all that a program has does so by `parted`, which sees to that.
    ``ready`` derives what the rule stands on, which it then finds kept with the analysis, in work that can be left at each step.
    """

    ready: Callable[[Any], Iterator[None]] | None = None


class Notice(NamedTuple):
    """Something that is no part of the program's grammar but was met on the way: ``kind`` is a rule's short name, ``said`` what the message is about."""

    kind: str
    line: int
    span: Span
    said: str


class Noticed(NamedTuple):
    """The rule is called for each notice of its own name: `check(notice)`; reports must name a line."""


class Moved(NamedTuple):
    """The rule is called with the moves of a run (deburr/motion): `check(path, machine)`; the lines of its reports are those of the flat program.

    ``needs``: the key of `[machine]` without which the rule is silent, or which may be false;
    ``unless_said``: what that key means in a `[machine]` that does not have it. Without `[machine]` all are silent.
    """

    needs: str
    unless_said: bool | None = None


class Ran(NamedTuple):
    """The rule is called for each fault of its own name that a run met: `check(fault)`. What can be seen without a run is no matter for it."""


class Proven(NamedTuple):
    """The rule is called for each proof of its own name that values give for all inputs (deburr/values): `check(proof)`. Other rules own proofs as well, in the proof's words."""


Trigger = Syntax | Nodes | Modal | Text | Long | Structure | Whole | Noticed | Moved | Ran | Proven
Check = Callable[..., Iterator[Report]]


@dataclass(frozen=True, eq=False)
class Rule:
    """A rule as it is found in its file."""

    name: str
    severity: Severity
    trigger: Trigger
    check: Check
    module: str
    """The file that it stands in."""
    default: bool
    met: Check | None = None
    """What the rule says of a fault that a run met; None: what the interpreter says."""
    input: bool = False
    """Whether only the operator, the machine or an input that was not given can decide: then `check` is silent and `expand` refuses."""

    @property
    def fix(self) -> Callable[[Any], Iterator[Any]] | None:
        """How its faults are mended: the `fix` of the rule's file (deburr/fix.py); None if it has none of its own."""
        found: Callable[[Any], Iterator[Any]] | None = getattr(import_module(self.module), "fix", None)
        return found

    def on_program(self, analysis: Any) -> Iterator[Report | None]:
        """What a rule on the whole program says, with a None wherever its work can be left."""
        return self.check(analysis)

    @property
    def page(self) -> str:
        """The manual page: the docstring of the rule's file."""
        return import_module(self.module).__doc__ or ""

    @cached_property
    def short(self) -> str:
        """The name without its dialect."""
        return self.name.partition(".")[2]

    @property
    def summary(self) -> str:
        """The page's first line."""
        return self.page.strip().partition("\n")[0]


def rule(
    severity: Severity, trigger: Trigger, *, default: bool = True, met: Check | None = None, input: bool = False
) -> Callable[[Callable[..., Iterator[Report | None]]], Rule]:
    """Make a generator the rule of its file. ``default``: whether it speaks unless asked to be silent; ``met`` and ``input``: see `Rule`."""

    def made(check: Callable[..., Iterator[Report | None]]) -> Rule:
        module = check.__module__
        folder, file = module.split(".")[-2:]
        name = f"{folder}.{file.replace('_', '-')}"
        check = cast(Check, check)
        said = check if isinstance(trigger, Ran) else met
        return Rule(name, severity, trigger, check, module, default, said, input)

    return made


def parted(
    items: Iterable[T], says: Callable[[Sequence[T]], Iterable[Report | None] | None]
) -> Iterator[Report | None]:
    """What a rule says of many things, some hundred at a time: between them its work can be left. ``says`` gives reports, or only takes note."""
    left = iter(items)
    while some := list(islice(left, MANY)):
        yield from says(some) or ()
        yield None


def covers(prefix: str, name: str) -> bool:
    """Whether a name, or the first words of one, means a rule: `cgt.table` covers `cgt.table-missing`, not `cgt.tables`."""
    return name == prefix or name.startswith((f"{prefix}.", f"{prefix}-"))


def expected(problem: Problem) -> str:
    """The expected set as the end of a message: `; expected a number or `[``, or nothing."""
    words = problem.expected
    if not words:
        return ""
    if len(words) == 1:
        return f"; expected {words[0]}"
    return f"; expected {', '.join(words[:-1])} or {words[-1]}"


def whole(part: Node | Problem) -> Span:
    """The columns of a node or a problem."""
    return Span(part.start, part.end)
