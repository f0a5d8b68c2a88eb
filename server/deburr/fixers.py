"""Fixes that many rules share: functions of a fault, and functions that make such. Never applies one."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from deburr.finding import Fix
from deburr.fix import Broken
from deburr_grammar.text import Edit, Pos

# Texts, not patterns: rules are loaded with their fixers by every check, and few need one.
_MEANT = r"did you mean [`']([^`']+)[`']\?"
_ADVISED = r"(?:did you mean|write|written|type) `([^`]+)`(?! (?:for|to|or|and|beside|before|on|as)\b)"
_BEFORE = r"write `([^`]+)` before it"
_AROUND = r"(\|[ \t]*|#<|o<|#|@|')(.*?)([ \t]*\||>|'|)"
"""Signs around a name, which a proposal may leave out."""
_AXES, _CODES = frozenset("XYZABCUVW"), frozenset("GM")
Fixer = Callable[[Broken], Iterator[Fix]]


def did_you_mean(broken: Broken) -> Iterator[Fix]:
    """The name that the message asks for: did you mean `X`?"""
    yield from _proposed(broken, _MEANT)


def advised(broken: Broken) -> Iterator[Fix]:
    """What the message says to write, in place of what it quotes first."""
    yield from _proposed(broken, _ADVISED)


def _proposed(broken: Broken, pattern: str) -> Iterator[Fix]:
    proposal = re.search(pattern, broken.finding.message)
    if proposal is None or not broken.quoted:
        return
    old, new = broken.quoted[0], proposal[1]
    around = re.fullmatch(_AROUND, old)
    if around is not None and not new.startswith(around[1].rstrip()):
        new = f"{around[1]}{new}{around[3]}" if old.lower() in broken.said.lower() else new
        old = old if old.lower() in broken.said.lower() else around[2]
    at = broken.text.lower().find(old.lower(), broken.span.start) - broken.span.start
    if at >= 0 and new != old:
        start = broken.span.start + at
        yield Fix(f"Change to `{new}`", (broken.edit(start, start + len(old), new),))


def corrected(broken: Broken) -> Iterator[Fix]:
    """What the message quotes second, in place of the fault: `a` is read as `A`."""
    if len(broken.quoted) > 1 and broken.quoted[0] == broken.said:
        yield broken.replaced(broken.quoted[1])


def deleted(broken: Broken) -> Iterator[Fix]:
    """The fault is left out."""
    yield broken.deleted(*broken.span)


def line_deleted(broken: Broken) -> Iterator[Fix]:
    """The line is left out, if the fault is all that is on it."""
    if broken.said.strip() == broken.text.strip():
        yield Fix("Delete the line", (broken.without_line(),))


def split(broken: Broken) -> Iterator[Fix]:
    """The line ends before the fault, and another begins with it."""
    before = broken.text[: broken.span.start]
    if before.strip():
        edit = broken.edit(len(before.rstrip()), broken.span.start, f"\n{_lead(broken)}")
        yield Fix("Split the line here", (edit,))


def parted(broken: Broken, words: Sequence[tuple[str, int]], one: int, other: int) -> Iterator[Fix]:
    """Two codes that exclude each other stand on lines of their own, if each has its own axis words and no other code may belong to both.

    ``words``: the letters of all words of the line, and where they start; ``one`` and ``other`` say which of them are the codes.
    """
    first, second = sorted((one, other))
    own, behind = ({letter for letter, _ in part} for part in (words[first + 1 : second], words[second + 1 :]))
    if not _AXES.isdisjoint(own) and not _AXES.isdisjoint(behind) and _CODES.isdisjoint(own | behind):
        start = words[second][1]
        edit = broken.edit(len(broken.text[:start].rstrip()), start, f"\n{_lead(broken)}")
        yield Fix(f"Split the line before `{broken.text[start:].split()[0]}`", (edit,))


def _lead(broken: Broken) -> str:
    """What a line that was part of another starts with: its blanks, and the sign by which an operator leaves both out."""
    return broken.indent + ("/" if broken.text.lstrip().startswith("/") else "")


def moved_above(broken: Broken) -> Iterator[Fix]:
    """The fault stands on a line of its own, above."""
    out = broken.deleted(*broken.span)
    if out.edits[0].start.line == out.edits[0].end.line:
        above = Edit(Pos(broken.line, 0), Pos(broken.line, 0), f"{_lead(broken)}{broken.said}\n")
        yield Fix(f"Write `{broken.said}` on a line of its own", (above, *out.edits))


def appended(broken: Broken, line: str) -> Fix:
    """One more line at the program's end."""
    end = Pos(broken.document.line_count, 0)
    ending = "" if not broken.document.line(broken.document.line_count - 1) else "\n"
    return Fix(f"Add `{line}` at the end", (Edit(end, end, f"{ending}{line}\n"),))


def blanks_left_out(broken: Broken, before: str) -> Iterator[Fix]:
    """The fault and a sign behind it without the blanks between them."""
    after = broken.text[broken.span.end :]
    blanks = len(after) - len(after.lstrip(" \t"))
    if blanks and after[blanks:].startswith(before):
        end = broken.span.end
        yield Fix("Delete the blanks", (broken.edit(end, end + blanks, ""),))


def line_before(broken: Broken) -> Iterator[Fix]:
    """A line before the fault's: write `X` before it."""
    wanted = re.search(_BEFORE, broken.finding.message)
    if wanted is not None:
        yield Fix(f"Write `{wanted[1]}` before it", (broken.edit(0, 0, f"{broken.indent}{wanted[1]}\n"),))


def closed(sign: str) -> Fixer:
    """A closing sign where the fault ends."""

    def fixer(broken: Broken) -> Iterator[Fix]:
        end = broken.span.start + len(broken.said.rstrip())
        yield broken.inserted(end, sign)

    return fixer


def safe(fixer: Fixer) -> Fixer:
    """The same, where it is certain what the program means."""

    def sure(broken: Broken) -> Iterator[Fix]:
        return (fix._replace(safe=True) for fix in fixer(broken))

    return sure


def either(*fixers: Fixer) -> Fixer:
    """What the first of several makes that makes anything."""

    def fixer(broken: Broken) -> Iterator[Fix]:
        yield from next((found for each in fixers if (found := list(each(broken)))), ())

    return fixer


_VALUE = r"(?i)\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+|#[0-9]+|#<[^<>]+>|[A-Z]+(?![A-Z(])))"


def bracketed(broken: Broken, signs: str) -> Iterator[Fix]:
    """The value behind the fault in brackets."""
    value = re.compile(_VALUE).match(broken.text, broken.span.end)
    if value is not None:
        text = f"{signs[0]}{value[1]}{signs[1]}"
        yield Fix(f"Write `{broken.said}{text}`", (broken.edit(*value.span(), text),))
