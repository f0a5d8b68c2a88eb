"""How the words of a conditional bracket are tested (spec/cgt.md §5.2, §11)."""

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass

from deburr.templates.items import Body, Item
from deburr.templates.template import Template
from deburr_grammar.text import Span


@dataclass(frozen=True, slots=True)
class Tests:
    """The words of a bracket that are tested, those that `#EXC` excludes, and operators that join nothing: with no word before them (``early``), behind `#EXC` or with no word behind them (``late``)."""

    tested: tuple[Item, ...]
    excluded: tuple[Item, ...]
    early: tuple[Item, ...]
    late: tuple[Item, ...]


def tests_of(body: Body) -> Tests:
    """What a bracket tests."""
    tested: list[Item] = []
    excluded: list[Item] = []
    early: list[Item] = []
    late: list[Item] = []
    waiting: list[Item] = []
    excepted = False
    for item in body.items():
        if item.kind == "word":
            (excluded if excepted else tested).append(item)
            waiting = []
        elif item.kind == "operator":
            # One that comes before the other has joined a word takes its place.
            late += waiting
            waiting = [] if excepted or not tested else [item]
            late += [item] if excepted and tested else []
            early += [] if tested or excluded else [item]
            excepted = excepted or item.name == "EXC"
    return Tests(tuple(tested), tuple(excluded), tuple(early), (*late, *waiting))


def read_brackets(template: Template) -> Iterator[Body]:
    """Every conditional bracket that is closed and holds no line with a syntax fault."""
    faulty = sorted(template.faulty_lines)
    for body in template.bodies:
        if body.kind == "bracket" and body.opener and body.closer:
            at = bisect_left(faulty, body.opener.line)
            if at == len(faulty) or faulty[at] > body.closer.line:
                yield body


def extent(body: Body) -> Span:
    """The columns of a bracket; of one that runs over lines, those of its `<`."""
    assert body.opener and body.closer
    same = body.opener.line == body.closer.line
    return Span(body.opener.start, body.closer.end if same else body.opener.end)
