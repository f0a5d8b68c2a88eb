"""How blocks are mended: the end that is missing, a number of their own. Where a block would end is a guess: its indented lines say it best."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from deburr.finding import Fix
from deburr.fix import Broken
from deburr_grammar.text import Edit, Pos

if TYPE_CHECKING:
    from collections.abc import Iterator

    from deburr.blocks import Block, Scope
    from deburr_grammar.structure import Placed

_PROGRAM_END = r"(?i)\s*(?:N[0-9]+\s*)?(?:M0*(?:2|30)\b|%)"
_NUMBER = re.compile(r"[0-9]+")


def ended(broken: Broken, end: str) -> Iterator[Fix]:
    """The missing end of the block that opens at the fault, on a line of its own."""
    found = _opened(broken)
    if found is not None:
        line = _last(broken, *found) + 1
        edit = Edit(Pos(line, 0), Pos(line, 0), f"{broken.indent}{end}\n")
        if line >= broken.document.line_count:
            last = Pos(line - 1, len(broken.document.line(line - 1)))
            edit = Edit(last, last, f"\n{broken.indent}{end}")
        yield Fix(f"Insert `{end}`", (edit,))


def renumbered(broken: Broken, number: int) -> Iterator[Fix]:
    """Another number for the block that opens at the fault: in all its brackets."""
    found = _opened(broken)
    if found is None or found[1] is None:
        return
    block = found[1]
    places = [block.opener, *(each for each in _inside(*found) if each is not None)]
    edits = [edit for placed in places if (edit := _numbered(broken, placed, number)) is not None]
    if block.closer is not None and len(edits) == len(places):
        yield Fix(f"Give the block the number {number}", tuple(edits))


def highest(broken: Broken, before: str) -> int:
    """The highest number that stands behind some sign anywhere in the program."""
    return max(map(int, re.findall(rf"{before}\s*([0-9]+)", broken.document.text, re.I)), default=0)


def _opened(broken: Broken) -> tuple[Scope, Block | None] | None:
    """The scope of the block that opens at the fault, and the block; None for a region that starts there."""
    for scope in broken.analysis.scopes:
        if scope.start is not None and _is_at(scope.start, broken):
            return scope, None
        for block in scope.blocks:
            if _is_at(block.opener, broken):
                return scope, block
    return None


def _is_at(placed: Placed, broken: Broken) -> bool:
    return placed.line == broken.line and placed.bracket.span.start == broken.span.start


def _last(broken: Broken, scope: Scope, block: Block | None) -> int:
    """The last line that would stand in the block: of those that are indented, else of all up to what ends it in any case."""
    limit = _limit(broken, scope, block)
    indent, line = len(broken.indent), broken.line
    for at in range(broken.line + 1, limit):
        text = broken.document.line(at)
        if not text.strip():
            continue
        if len(text) - len(text.lstrip()) <= indent:
            break
        line = at
    if line > broken.line:
        return line
    while limit - 1 > broken.line and not broken.document.line(limit - 1).strip():
        limit -= 1
    return limit - 1


def _limit(broken: Broken, scope: Scope, block: Block | None) -> int:
    """The first line that cannot be in the block: the end of what is around it, the next region, the end of the program."""
    around = block.around if block is not None else None
    ends = [around.closer.line] if around is not None and around.closer is not None else []
    ends += [scope.end.line] if scope.end is not None and block is not None else []
    ends += [each.place.line for each in broken.finding.related if each.place.file == broken.analysis.file]
    ends += [each.start.line for each in broken.analysis.scopes if each.start is not None and each is not scope]
    count = broken.document.line_count
    ends += [at for at in range(broken.line, count) if re.match(_PROGRAM_END, broken.document.line(at))][:1]
    return min((end for end in ends if end > broken.line), default=count)


def _inside(scope: Scope, block: Block | None) -> Iterator[Placed | None]:
    """The brackets that name a block: its end, and what stands in it or deeper and names it."""
    if block is None:
        return
    yield block.closer
    label = block.opener.bracket.label
    for placed, inner in scope.middles:
        around = list(inner.outward()) if inner is not None else []
        same = next((each for each in around if each.opener.bracket.label == label), None)
        if placed.bracket.label == label and same is block:
            yield placed


def _numbered(broken: Broken, placed: Placed, number: int) -> Edit | None:
    start, end = placed.bracket.span
    found = _NUMBER.search(broken.document.line(placed.line), start, end)
    if found is None:
        return None
    return Edit(Pos(placed.line, found.start()), Pos(placed.line, found.end()), str(number))
