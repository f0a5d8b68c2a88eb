"""Loop variable that the body never refers to.

Every pass then writes the same lines. That repeats them, and may be meant; more often the name in
the body is spelled another way.

Source: spec/metagcode.md §6

Bad:

    #LOOP1 |z| 2 c
           ^^^
    G0
    #ENDLOOP1

Bad:

    #LOOP1 |Depth| 2 c |Step| 1 r
           ^^^^^^^
    G1 Z-|depth| X|Step|
    #ENDLOOP1

Good:

    #LOOP1 |z| 2 c
    #FILE peck.txt
    #ENDLOOP1
    #LOOP1 |n| 1 c
    (pass | n |)
    #ENDLOOP1
    -- Snippets/peck.txt --
    G1 Z-|z|
"""

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, Gathered, gathered, ready
from deburr.rules.metagcode._variables import names_of
from deburr.rules.metagcode._words import nearest
from deburr.steps import paced
from deburr_grammar.dialects.metagcode.forms import counters
from deburr_grammar.dialects.metagcode.limits import NESTED
from deburr_grammar.document import Document
from deburr_grammar.text import Span

_COMPARED = 100
"""So many names of a body are compared with one that it lacks."""


@rule(Severity.INFO, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the variable in the header. An empty body says nothing, and what a missing snippet says is not known."""
    blocks, document = gathered(analysis), analysis.document
    lines = [line for line, _ in blocks.files]
    for pair in paced(blocks.pairs):
        if pair is None:
            yield None
            continue
        opener, closer, depth = pair
        if opener.bracket.kind != "loop" or Foreign in (type(opener.bracket), type(closer.bracket)) or depth > NESTED:
            continue
        first, stop = opener.line + 1, closer.line
        unknown = bisect_left(blocks.unknown, first) < bisect_left(blocks.unknown, stop)
        for name, token in dict(counters(document.node(opener.line))).items() if not unknown else ():
            used = _named(document, name, first, stop) or _brought(blocks, lines, name, first, stop)
            if not used and any(document.line(line).strip() for line in range(first, stop)):
                hint = nearest(name, islice(_names(document, first, stop), _COMPARED))
                message = f"no line of the loop refers to `|{name}|`, so every pass is the same{hint}"
                yield Report(Span(token.start, token.end), message, opener.line)


def _brought(blocks: Gathered, lines: Sequence[int], name: str, first: int, stop: int) -> bool:
    """Whether a snippet in the body refers to the name, or may do so."""
    inside = lines[bisect_left(lines, first) : bisect_left(lines, stop)]
    effects = (blocks.effects[line] for line in inside)
    return any(effect is None or not effect.sure or name in effect.names for effect in effects)


def _named(document: Document, name: str, first: int, stop: int) -> bool:
    """Whether a line of the program refers to the name."""
    for at, rows in _rows(document, first, stop):
        found = rows.get(name, ())
        index = bisect_left(found, first - at)
        if index < len(found) and found[index] < stop - at:
            return True
    return False


def _names(document: Document, first: int, stop: int) -> Iterator[str]:
    """The names on some lines."""
    chunks = ((at, rows.items()) for at, rows in _rows(document, first, stop))
    met = ((name, first - at, stop - at, rows) for at, names in chunks for name, rows in names if name)
    return (name for name, low, high, rows in met if bisect_left(rows, low) < bisect_left(rows, high))


def _rows(document: Document, first: int, stop: int) -> Iterator[tuple[int, Mapping[str, Sequence[int]]]]:
    """The chunks of some lines: the first line of each, and its names with the lines in which they stand."""
    line = first
    while line < stop:
        piece = document.piece(line)
        yield piece.line, names_of(piece.chunk)
        line = piece.line + max(piece.chunk.eols, 1)


fix = did_you_mean
