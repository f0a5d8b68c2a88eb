"""APT/CL text, the toolpath that CAM systems write: its statements with their places (spec/cgt.md §6, §11). Never opens a file, never says what a statement does."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple

from deburr.formats import Fault
from deburr.suggest import suggestion
from deburr_grammar.text import Span, split_lines

if TYPE_CHECKING:
    from collections.abc import Iterator


class Statement(NamedTuple):
    """A statement that can be used: its word in capitals, its numbers, the words among its values in capitals, and the text of a PARTNO or PPRINT."""

    word: str
    line: int
    span: Span
    numbers: tuple[float, ...] = ()
    choices: tuple[str, ...] = ()
    text: str = ""


class Toolpath(NamedTuple):
    """The statements up to FINI in order, and what is wrong with the others."""

    statements: tuple[Statement, ...]
    faults: tuple[Fault, ...]


class _Form(NamedTuple):
    """How a statement is written, in words and in slots: N a number, U one from 0 on, P one above 0, I a whole one from 0 on, else words.

    ``rest``: what may stand behind: "" nothing, "any" values that are its own, "ignored" values that are not read.
    """

    said: str
    ways: tuple[str, ...]
    rest: str = ""


class _Value(NamedTuple):
    """A value of a statement; ``said`` is empty where one is missing between commas."""

    said: str
    line: int
    span: Span


_UNITS = "IPM|IPR|FPM|MMPM|MMPR|MPM|PERMIN|PERREV"
_FORMS = {
    "UNITS": _Form("`UNITS/MM` or `UNITS/INCH`", ("MM|INCH",)),
    "LOADTL": _Form("`LOADTL/n`", ("I",), "ignored"),
    "SPINDL": _Form("`SPINDL/RPM,s,CLW`, `SPINDL/RPM,s,CCLW` or `SPINDL/OFF`", ("RPM U CLW|CCLW", "OFF"), "ignored"),
    "COOLNT": _Form("`COOLNT/ON`, `FLOOD`, `MIST` or `OFF`", ("ON|OFF|FLOOD|MIST",), "ignored"),
    "FEDRAT": _Form("`FEDRAT/f` or `FEDRAT/f,unit`", (f"U {_UNITS}", "U")),
    "CUTCOM": _Form(
        "`CUTCOM/LEFT,n`, `CUTCOM/RIGHT,n` or `CUTCOM/OFF`", ("LEFT|RIGHT I", "LEFT|RIGHT", "OFF"), "ignored"
    ),
    "RAPID": _Form("`RAPID`", ("",)),
    "GOTO": _Form("`GOTO/x,y,z` or `GOTO/x,y,z,i,j,k`", ("N N N", "N N N N N N")),
    "FROM": _Form("`FROM/x,y,z`", ("N N N", "N N N N N N")),
    "CIRCLE": _Form("`CIRCLE/x,y,z,i,j,k,r`", ("N N N N N N P",)),
    "CYCLE": _Form(
        "`CYCLE/DRILL`, `CBORE`, `FACE`, `DEEP`, `BRKCHP`, `TAP`, `BORE` or `OFF`",
        ("DRILL|CBORE|FACE|DEEP|BRKCHP|TAP|BORE", "OFF"),
        "any",
    ),
    "DELAY": _Form("`DELAY/t`", ("U",)),
    "FINI": _Form("`FINI`", ("",)),
}
_TEXTS = ("PARTNO", "PPRINT", "TOOL NAME")
_HEAD = re.compile(r"[ \t]*(tool[ \t]+name(?![A-Za-z0-9_])|[A-Za-z][A-Za-z0-9_-]*)", re.I)
_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[Ee][+-]?[0-9]+)?")
_PLAIN = r"[ \t]*([+-]?[0-9]{1,15}(?:\.[0-9]{0,15})?)[ \t]*"
_POINT = re.compile(rf"[ \t]*(GOTO[ \t]*/{_PLAIN},{_PLAIN},[ \t]*([+-]?[0-9]{{1,15}}(?:\.[0-9]{{0,15}})?))[ \t]*", re.I)
"""A point as toolpaths write it; what is written otherwise is read slowly."""
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")
_FLAT = 1e-4
"""How far an axis of length 1 may lean: CAM systems write seven decimals, and some write four."""
_KINDS = {"N": "a number", "U": "a number from 0 on", "P": "a number above 0", "I": "a whole number from 0 on"}

_Segments = list[tuple[int, str]]


def read(text: str) -> Toolpath:
    """The toolpath in a text."""
    found: list[Statement] = []
    faults: list[Fault] = []
    unknown: dict[str, list[Fault]] = {}
    for each in statements(text):
        if isinstance(each, Statement):
            found.append(each)
        elif each.ignored:
            unknown.setdefault(each.message, []).append(each)
        else:
            faults.append(each)
    faults += [_once(same) for same in unknown.values()]
    return Toolpath(tuple(found), tuple(sorted(faults)))


def statements(text: str) -> Iterator[Statement | Fault]:
    """The statements up to FINI one after the other, and in their places what is wrong."""
    for segments in _logical(split_lines(text)):
        line, code = segments[0]
        if len(segments) == 1 and (point := _POINT.fullmatch(code)) is not None:
            # Nearly all lines of a toolpath are these.
            yield Statement("GOTO", line, Span(*point.span(1)), (float(point[2]), float(point[3]), float(point[4])))
            continue
        found = _statement(segments)
        yield from found
        if any(isinstance(each, Statement) and each.word == "FINI" for each in found):
            return


def plane(statement: Statement) -> tuple[int, int] | None:
    """The axis of a CIRCLE (0 X, 1 Y, 2 Z) and its sense, 1 or -1; None if it leans."""
    axis = statement.numbers[3:6]
    length = math.hypot(*axis)
    if length == 0 or not math.isfinite(length):
        return None
    main = max(range(3), key=lambda at: abs(axis[at]))
    if any(abs(axis[at]) / length > _FLAT for at in range(3) if at != main):
        return None
    return main, 1 if axis[main] > 0 else -1


def _logical(lines: list[str]) -> Iterator[_Segments]:
    """Statements as the pieces of the lines that they stand on: `$$` starts a comment, one `$` at a line's end joins the next line."""
    segments: _Segments = []
    for number, line in enumerate(lines):
        code = line.partition("$$")[0].rstrip(" \t")
        goes_on = code.endswith("$")
        segments.append((number, code[:-1] if goes_on else code))
        if len(segments) == 1 and not segments[0][1].strip(" \t") and number < len(lines) - 1:
            segments = []  # A blank line in front of a statement is none of its lines.
        elif not goes_on:
            if any(said.strip(" \t") for _, said in segments):
                yield segments
            segments = []
    if any(said.strip(" \t") for _, said in segments):
        yield segments


def _statement(segments: _Segments) -> list[Statement | Fault]:
    line, code = segments[0]
    span = Span(len(code) - len(code.lstrip(" \t")), len(code.rstrip(" \t")))
    head = _HEAD.match(code)
    if head is None:
        said = code.strip(" \t") or "$"
        where = Span(span.start, max(span.end, span.start + 1))
        return [Fault(line, where, f"`{said}` is no statement; it starts with a word such as `GOTO/`")]
    word = " ".join(head[1].upper().split())
    if word in _TEXTS:
        text = " ".join([code[head.end() :], *(said for _, said in segments[1:])]).strip(" \t")
        return [Statement(word, line, span, text=text.removeprefix("/").strip(" \t"))]
    if word not in _FORMS:
        hint = suggestion(word, (*_FORMS, *_TEXTS))
        return [
            Fault(line, Span(*head.span(1)), f"`{word}` is no statement that is read, so it is ignored{hint}", True)
        ]
    between = code[head.end() :].strip(" \t")
    if between and not between.startswith("/"):
        message = f"`/` is missing behind `{word}`; write {_FORMS[word].said}"
        return [Fault(line, span, message)]
    slash = code.find("/", head.end()) if between else len(code)
    values = list(_values([(line, code[slash + 1 :], slash + 1), *((at, said, 0) for at, said in segments[1:])]))
    return list(_read_as(word, line, span, values))


def _values(segments: list[tuple[int, str, int]]) -> Iterator[_Value]:
    """The values between commas; none at all of a statement that has nothing behind its word."""
    found: list[_Value] = []
    comma: _Value | None = None
    empty = True
    for line, code, first in segments:
        for match in re.finditer(r",|[^, \t]+(?:[ \t]+[^, \t]+)*", code):
            span = Span(first + match.start(), first + match.end())
            if match[0] != ",":
                found.append(_Value(match[0], line, span))
                empty = False
            else:
                comma = _Value("", line, span)
                found += [comma] if empty else []
                empty = True
    yield from found
    if comma is not None and empty:
        yield comma


def _read_as(word: str, line: int, span: Span, values: list[_Value]) -> Iterator[Statement | Fault]:
    form = _FORMS[word]
    for value in values:
        if not (_NUMBER.fullmatch(value.said) or _WORD.fullmatch(value.said)):
            yield Fault(value.line, value.span, f"{_no_value(value.said)}; write {form.said}")
            return
    tries = [_fitted(way.split(), values) for way in form.ways]
    count = max(tries)
    whole = [fitted for fitted, way in zip(tries, form.ways) if fitted == len(way.split())]
    if not whole or (len(values) > max(whole) and not form.rest):
        yield _misfit(word, line, span, values, count)
        return
    used = values[: max(whole)]
    numbers = tuple(float(value.said) for value in used if _NUMBER.fullmatch(value.said))
    choices = tuple(value.said.upper() for value in used if not _NUMBER.fullmatch(value.said))
    made = Statement(word, line, span, numbers, choices)
    if word == "CIRCLE" and plane(made) is None:
        message = "the axis i,j,k of a `CIRCLE` must be X, Y or Z; write 0,0,1 or 0,0,-1 for XY"
        yield Fault(values[3].line, _extent(values[3:6]), message)
        return
    yield made
    if form.rest == "ignored":
        yield from _ignored(word, values[max(whole) :])


def _no_value(said: str) -> str:
    if not said:
        return "a value is missing beside this comma"
    parts = said.split()
    if len(parts) > 1 and all(_NUMBER.fullmatch(part) or _WORD.fullmatch(part) for part in parts):
        return f"a comma is missing in `{said}`"
    return f"`{said}` is neither a number nor a word"


def _fitted(way: list[str], values: list[_Value]) -> int:
    """How many values fit a way to write the statement."""
    count = 0
    for slot, value in zip(way, values):
        if not _fits(slot, value.said):
            break
        count += 1
    return count


def _fits(slot: str, said: str) -> bool:
    if slot not in _KINDS:
        return said.upper() in slot.split("|")
    if not _NUMBER.fullmatch(said):
        return False
    number = float(said)
    least = {"N": -math.inf, "U": 0.0, "P": 0.0, "I": 0.0}[slot]
    within = math.isfinite(number) and number >= least and (slot != "P" or number > 0)
    return within and (slot != "I" or number.is_integer())


def _misfit(word: str, line: int, span: Span, values: list[_Value], count: int) -> Fault:
    form = _FORMS[word]
    if count >= len(values):
        has = "no value" if not values else "1 value" if len(values) == 1 else f"{len(values)} values"
        return Fault(line, span, f"`{word}` has {has}; write {form.said}")
    value = values[count]
    behind = f"; write {form.said}"
    wanted = [
        way.split()[count] for way in form.ways if len(way.split()) > count and _fitted(way.split(), values) == count
    ]
    if not wanted:
        return Fault(value.line, value.span, f"`{value.said}` is one value too many for `{word}`{behind}")
    if wanted[0] in _KINDS:
        return Fault(value.line, value.span, f"`{value.said}` stands where `{word}` takes {_KINDS[wanted[0]]}{behind}")
    hint = suggestion(value.said.upper(), [choice for slot in wanted for choice in slot.split("|")])
    return Fault(value.line, value.span, f"`{word}` does not take `{value.said}` here{hint or behind}")


def _ignored(word: str, values: list[_Value]) -> Iterator[Fault]:
    if values and (word, values[0].said.upper()) != ("LOADTL", "ADJUST"):
        message = f"what stands behind the values of `{word}` is not read, so it is ignored"
        yield Fault(values[0].line, _extent(values), message, True)


def _extent(values: list[_Value]) -> Span:
    """The columns of values, as far as they stand on the first one's line."""
    first, last = values[0], values[-1]
    return Span(first.span.start, last.span.end if last.line == first.line else first.span.end)


def _once(same: list[Fault]) -> Fault:
    """One fault for all statements of a word that is not read: a toolpath may hold thousands."""
    more = len(same) - 1
    also = f" (also on {more} more line{'s' if more > 1 else ''})" if more else ""
    return same[0]._replace(message=same[0].message + also)
