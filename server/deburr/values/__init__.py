"""What variables can hold, proven for all inputs: constants and ranges along every way a program can take (design.md §4).

`deburr.values.<id>` gives a language's routines and their flow; it is found by that name and
optional. A faulty program is no error of ours. Nothing is imported here that a program without variables does not need.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

if TYPE_CHECKING:
    from types import ModuleType

    from deburr.analysis import Analysis
    from deburr.finding import Finding
    from deburr.values.domain import Value
    from deburr.values.program import Program
    from deburr_grammar.document import Document
    from deburr_grammar.text import Span

_MEMO = "values"
_SMALL = 2_000
"""Lines of a program that is gone through while somebody waits for it; of a longer one is told what a check has found."""
_of_documents: WeakKeyDictionary[Document, Program | None] = WeakKeyDictionary()


def language(dialect: str) -> ModuleType | Any:
    """What knows the flow of a dialect's programs; None if nothing does."""
    name = f"{__name__}.{dialect}"
    return import_module(name) if find_spec(name) is not None else None


def values_of(analysis: Analysis) -> Program | None:
    """The values of a program; None where nothing is known of its language, or of its flow."""
    for _ in solving(analysis):
        pass
    found: Program | None = analysis.memo[_MEMO]
    return found


def proving(analysis: Analysis) -> Iterator[Finding | None]:
    """What is certain to go wrong, as findings of the rules that own it; as work that can be left wherever it yields None."""
    yield from solving(analysis)
    program = values_of(analysis)
    if program is not None:
        from deburr.values.proofs import findings

        yield from findings(program, analysis, language(analysis.dialect.name).written)


def solving(analysis: Analysis) -> Iterator[None]:
    """Find the values of a program, in work that can be left at each step. They are kept with the analysis."""
    if _MEMO in analysis.memo:
        return
    program = yield from _program(analysis)
    if program is not None:
        yield from program.solving()
    analysis.memo[_MEMO] = _of_documents[analysis.document] = program


def value_at(analysis: Analysis, line: int, written: str, behind: bool) -> Value | None:
    """What a variable holds before a line, or ``behind`` it; None if nothing is proven of it. ``written``: as one writes the variable."""
    program = _at_hand(analysis)
    if program is None:
        return None
    return program.value(analysis.file, line, language(analysis.dialect.name).read(written), behind)


class Told(NamedTuple):
    """What is proven of a variable at a place, in words: what it holds, and where that comes from.

    ``number``: the one that it is; ``passes``: of the loop around it that it counts.
    """

    text: str
    why: str
    number: str | None
    passes: int | None


def told_at(analysis: Analysis, line: int, written: str, behind: bool) -> Told | None:
    """What a variable holds before a line, or ``behind`` it; None if nothing is proven of it. ``written``: as one writes the variable."""
    program = _at_hand(analysis)
    if program is None:
        return None
    from deburr.values.tell import told

    module = language(analysis.dialect.name)
    return told(program, analysis, line, module.read(written), behind, module.written)


def passes_at(analysis: Analysis, line: int) -> tuple[Span, int] | None:
    """How often the loop goes round whose condition stands on a line, and the columns of its command; None if that is not proven."""
    program = _at_hand(analysis)
    if program is None:
        return None
    from deburr.values.tell import turns

    return turns(program, analysis.file, line)


def all_passes(analysis: Analysis) -> Iterator[tuple[int, Span, int]]:
    """How often each loop goes round, where that is proven: the line of its condition, the columns of its command, the number."""
    program = _at_hand(analysis)
    if program is not None:
        from deburr.values.tell import all_turns

        yield from all_turns(program, analysis.file)


def _at_hand(analysis: Analysis) -> Program | None:
    """What is proven, if a check has found it already or a person can wait for it."""
    document = analysis.document
    if language(analysis.dialect.name) is None:
        return None
    if document not in _of_documents and document.line_count > _SMALL:
        return None
    return _of_documents[document] if document in _of_documents else values_of(analysis)


def _program(analysis: Analysis) -> Generator[None, None, Program | None]:
    module = language(analysis.dialect.name)
    if module is None or not (yield from module.worth(analysis.document)):
        return None
    routines = yield from module.routines(analysis)
    if routines is None:
        return None
    from deburr.values.program import Program

    return Program(routines)
