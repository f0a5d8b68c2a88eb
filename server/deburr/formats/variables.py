"""The file in which the values of variables stand: name=value lines, or a JSON object (spec/metagcode.md §5.2). Never opens it.

Blank lines and lines that begin with `#` or `;` say nothing. A file is JSON if it begins with
`{` or is called `.json`; numbers count as they are written there.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from deburr_grammar.text import Span, line_starts, split_lines

_KEYS = re.compile(r'("(?:[^"\\]|\\.)*")(\s*:)?|([\[{])|[\]}]')
_ERROR = re.compile(r"^(.*): line [0-9]+ column [0-9]+ \(char ([0-9]+)\)$")


class Value(NamedTuple):
    """The text that a name stands for, and where it is defined: a 0-based line and its columns."""

    text: str
    line: int
    span: Span


class Defect(NamedTuple):
    """A place of the file that cannot be understood, and why."""

    line: int
    span: Span
    why: str


class Values(NamedTuple):
    """What a file defines. ``whole``: nothing in it was passed over, so a name that is missing is not defined."""

    known: Mapping[str, Value]
    defects: tuple[Defect, ...]
    whole: bool


def read_values(text: str, path: str) -> Values:
    """The values in a file of that name. Where a name is defined twice with different values the last one holds."""
    text = text.removeprefix("\ufeff")
    is_json = text.lstrip()[:1] == "{" or path.lower().endswith(".json")
    known: dict[str, Value] = {}
    defects: list[Defect] = []
    whole = True
    for name, value in _json(text) if is_json else _lines(text):
        before = known.get(name)
        if isinstance(value, Defect):
            whole = False
            defects.append(value)
        else:
            known[name] = value
            if before is not None and before.text != value.text:
                defects.append(Defect(value.line, value.span, f"`{name}` has another value on line {before.line + 1}"))
    return Values(known, tuple(defects), whole)


def _lines(text: str) -> Iterator[tuple[str, Value | Defect]]:
    for at, line in enumerate(split_lines(text)):
        said = line.strip(" \t")
        if not said or said[0] in "#;":
            continue
        start = line.index(said[0])
        span = Span(start, start + len(said))
        name, sign, value = said.partition("=")
        name = name.rstrip(" \t")
        fault = "" if sign else f"`{said}` has no `=`"
        yield name, _defined(name, value.lstrip(" \t"), at, span, fault)


def _json(text: str) -> Iterator[tuple[str, Value | Defect]]:
    import json

    try:
        read = json.loads(text, object_pairs_hook=_Object, parse_int=str, parse_float=str, parse_constant=_nothing)
    except (ValueError, RecursionError) as error:
        yield "", _broken(text, error)
        return
    if not isinstance(read, _Object):
        yield "", Defect(0, Span(0, 1), "it is JSON but no object of names and values")
        return
    places = _key_places(text)
    for name, value in read:
        line, span = next(places)
        said = name.strip(" \t")
        fault = "" if isinstance(value, str) else f"the value of `{said}` is neither text nor a number"
        yield said, _defined(said, value if isinstance(value, str) else "", line, span, fault)


class _Object(list[tuple[str, Any]]):
    """The names and values of a JSON object as they follow each other."""


def _nothing(_: str) -> None:
    """`NaN` and its like are no numbers."""


def _defined(name: str, text: str, line: int, span: Span, fault: str) -> Value | Defect:
    if not fault and not name:
        fault = "a value stands here without a name"
    if not fault and ("|" in name or "\n" in name or "\r" in name):
        fault = f"`{name.splitlines()[0]}` is no name that can stand between two bars"
    return Defect(line, span, fault) if fault else Value(text, line, span)


def _broken(text: str, error: ValueError | RecursionError) -> Defect:
    """What is wrong with a text that is no JSON; where its line or the text ends too soon, the last character stands for it."""
    said = _ERROR.match(str(error))
    if said is None:
        return Defect(0, Span(0, 1), "it is no JSON that can be read")
    at = int(said[2])
    line = bisect_right(line_starts(text), at) - 1
    col = max(0, min(at - line_starts(text)[line], len(split_lines(text)[line]) - 1))
    return Defect(line, Span(col, col + 1), f"it is no JSON: {said[1][:1].lower()}{said[1][1:]}")


def _key_places(text: str) -> Iterator[tuple[int, Span]]:
    """Where the names of the outermost object stand."""
    starts, depth = line_starts(text), 0
    for match in _KEYS.finditer(text):
        if match[1] is None:
            depth += 1 if match[3] else -1
        elif match[2] is not None and depth == 1:
            line = bisect_right(starts, match.start()) - 1
            yield line, Span(match.start() - starts[line], match.end(1) - starts[line])
