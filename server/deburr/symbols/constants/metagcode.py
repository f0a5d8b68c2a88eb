"""Values of MetaGCODE: the configured file of values, and what loops make of them (spec/metagcode.md §5.2, §5.4)."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from functools import lru_cache, partial
from typing import TYPE_CHECKING

from deburr.arithmetic.metagcode import DECIMALS, Counted, passes
from deburr.formats.variables import Value as Given
from deburr.formats.variables import Values, read_values
from deburr.includes import Folder, beside
from deburr.symbols.constants import Held, Length, Settings, Value, count
from deburr.symbols.metagcode import counted as counters_of
from deburr.symbols.metagcode import loops_around
from deburr_grammar.dialects.metagcode.forms import Group, number
from deburr_grammar.dialects.metagcode.forms import name as name_of
from deburr_grammar.text import Span

if TYPE_CHECKING:
    from decimal import Decimal

    from deburr.host import Host
    from deburr.symbols import Mention, Symbol
    from deburr_grammar.document import Document
    from deburr_grammar.line import LineNode


def assigned(document: Document, line: int, mention: Mention, settings: Settings) -> None:
    """No line assigns: values come from outside."""


def given(symbol: Symbol, file: str, settings: Settings, host: Host) -> Value | None:
    """What the configured file says of a variable; of one in a snippet nothing, because loops may be around it."""
    if Folder(host, file, str(settings["snippets-dir"])).inside:
        return None
    path, values = _values(file, settings, host)
    found = values.get(symbol.name)
    if found is None or set("|\r\n") & set(found.text):
        return None
    return Value(found.text, f"`{path.rpartition('/')[2]}` line {found.line + 1}")


def names(file: str, settings: Settings, host: Host) -> Iterator[str]:
    """The variables in the configured file."""
    yield from (f"|{name}|" for name in _values(file, settings, host)[1])


def counted(document: Document, line: int, symbol: Symbol, total: Value | None, held: Held) -> Value | None:
    """What the loop around a line makes of its variable; nothing where several loops count the same."""
    found = [each for each in loops_around(document, line) if symbol.name in dict(each[1])]
    if not found:
        return total
    if len(found) > 1:
        return None
    at, counters = found[0]
    group, node = dict(counters)[symbol.name], document.node(at)
    every = _passes(node, [each for _, each in counters], partial(held, at))
    value = number(total.first.strip(" \t")) if total is not None and total.plain is not None else None
    if every is None or value is None or not every or total is None:
        return None
    relative = node.text[group.mode.start] in "rR"
    return _course(value, every, relative, f"{_head(node)} in line {at + 1}, {total.first} in {total.why}")


def disturbed(document: Document, first: int, last: int) -> bool:
    """Nothing changes what comes from outside."""
    return False


def results(line: LineNode, settings: Settings) -> Iterator[tuple[Span, str]]:
    """There are no expressions."""
    yield from ()


def lengths(document: Document, line: int, held: Held, settings: Settings) -> Iterator[Length]:
    """Of a loop's head: how often it goes round, and the step of each variable."""
    node = document.node(line)
    counters = counters_of(node)
    every = _passes(node, [group for _, group in counters], partial(held, line))
    if not every:
        return
    for index, (name, group) in enumerate(counters):
        known = held(line, name)
        total = number((known.first if known is not None else "").strip(" \t"))
        assert total is not None, "the number of passes came from it"
        step = f"step {_step(total, every)}"
        yield Length(Span(group.mode.start, group.mode.end), step if index else f"{count(every)}, {step}")


def row(document: Document, line: int, mention: Mention) -> None:
    """There are no tables."""


def _values(file: str, settings: Settings, host: Host) -> tuple[str, Mapping[str, Given]]:
    """The configured file and what is in it."""
    setting = str(settings["variables"])
    path = beside(file, setting) if setting else ""
    text = host.read(path) if setting else None
    return path, {} if text is None else _read(text, path).known


@lru_cache(8)
def _read(text: str, path: str) -> Values:
    return read_values(text, path)


def _passes(node: LineNode, counters: list[Group], held: Callable[[str], Value | None]) -> int | None:
    """How often a loop goes round; None if it cannot be told."""
    most = 0
    for group in counters:
        known = held(name_of(node.text[group.counter.start : group.counter.end]))
        total = None if known is None or known.plain is None else number(known.first.strip(" \t"))
        size = _size(node, group, held)
        if total is None or not size:
            return None
        most = max(most, passes(total, size))
    return most if counters else None


def _size(node: LineNode, group: Group, held: Callable[[str], Value | None]) -> Decimal | None:
    said = node.text[group.step.start : group.step.end]
    if group.step.kind == "VARIABLE":
        known = held(name_of(said))
        said = known.first.strip(" \t") if known is not None and known.plain is not None else ""
    return number(said)


def _course(total: Decimal, every: int, relative: bool, why: str) -> Value:
    printed = Counted(total, every, DECIMALS, False).printed
    first, last = printed(1), printed(every)
    if relative:
        return Value(f"{_step(total, every)} each time", why, passes=every)
    return Value(first, why, last if every > 1 else "", _step(total, every) if every > 1 else "", every)


def _exact(total: Decimal, every: int) -> bool:
    return bool((Fraction(total) / every * 10**DECIMALS).denominator == 1)


def _step(total: Decimal, every: int) -> str:
    """The step as it is printed; a rounded one is marked."""
    return f"{'' if _exact(total, every) else '≈ '}{Counted(total, every, DECIMALS, False).printed(1)}"


def _head(node: LineNode) -> str:
    return f"`{node.text.split()[0]}`"
