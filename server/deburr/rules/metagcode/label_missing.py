"""Directive without its number.

`#IF`, `#ENDIF`, `#LOOP` and `#ENDLOOP` carry a number directly behind the word, with no blank: it
ties the two ends of a block together. Without it an end fits any block, and a block that was
closed in the wrong place is not noticed.

Source: spec/metagcode.md §2, §6

Bad:

    #IF |a| equalto 1 n
    ^^^
    #ENDIF
    ^^^^^^

Bad:

    #LOOP 1 |z| 2 c
    ^^^^^
    G0 Z|z|
    #ENDLOOP-1
    ^^^^^^^^

Good:

    #LOOP07 |z| 2 c
    G0 Z|z|
    #ENDLOOP07
"""

import re
from collections.abc import Iterator

from deburr.blockfix import highest
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Edit, Pos, Span
from deburr_grammar.tree import Node


@rule(Severity.ERROR, Nodes(("if", "endif", "loop", "endloop"), by_shape=True))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the keyword."""
    if node.find("LABEL") is None:
        keyword = node.children[0]
        word = line.said(keyword)
        yield Report(
            Span(keyword.start, keyword.end),
            f"`{word}` has no number, so nothing ties it to its other end; write it as in `{word}1`, with no blank",
        )


def fix(broken: Broken) -> Iterator[Fix]:
    """Join a number that a blank keeps apart; else give both ends one that nothing else has."""
    apart = re.match(r"[ \t]+(?=[0-9]+(?:\s|$))", broken.text[broken.span.end :])
    if apart is not None:
        end = broken.span.end
        yield Fix("Delete the blank", (broken.edit(end, end + apart.end(), ""),))
        return
    lines = [broken.line, *(at for at in [_partner(broken)] if at is not None)]
    number = highest(broken, "#(?:IF|LOOP)") + 1
    places = [(at, found) for at in lines if (found := _BARE.match(broken.document.line(at)))]
    if len(places) == len(lines) == 2:
        edits = [Edit(Pos(at, found.end()), Pos(at, found.end()), str(number)) for at, found in places]
        yield Fix(f"Give the block the number {number}", tuple(edits))


_BARE = re.compile(r"\s*#(?:END)?(?:IF|LOOP)(?=\s|$)", re.I)


def _partner(broken: Broken) -> int | None:
    """The line of the block's other end."""
    brackets = broken.document.piece(broken.line)
    own = next((each for at, each in brackets.outlined.brackets if brackets.line + at == broken.line), None)
    other = broken.document.partner(broken.line, own) if own is not None else None
    return other[0] if other is not None else None
