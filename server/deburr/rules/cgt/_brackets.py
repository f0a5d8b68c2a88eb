"""How the words of a conditional bracket are tested (spec/cgt.md §5.2, §11)."""

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass

from deburr.rules.cgt._template import Body, Item, Template
from deburr_grammar.text import Span


@dataclass(frozen=True, slots=True)
class Tests:
    """The words of a bracket that are tested, those that `#EXC` excludes, and operators with no word before them."""

    tested: tuple[Item, ...]
    excluded: tuple[Item, ...]
    early: tuple[Item, ...]


def tests_of(body: Body) -> Tests:
    """What a bracket tests."""
    tested: list[Item] = []
    excluded: list[Item] = []
    early: list[Item] = []
    excepted = False
    for item in body.items():
        if item.kind == "word":
            (excluded if excepted else tested).append(item)
        elif item.kind == "operator":
            early += [] if tested or excluded else [item]
            excepted = excepted or item.name == "EXC"
    return Tests(tuple(tested), tuple(excluded), tuple(early))


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
