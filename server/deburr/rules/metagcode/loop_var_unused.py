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
from collections.abc import Iterator, Mapping

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, Gathered, gathered
from deburr_grammar.chunk import Chunk
from deburr_grammar.dialects.metagcode.forms import counters, names
from deburr_grammar.document import Document
from deburr_grammar.text import Span


@rule(Severity.INFO, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the variable in the header. An empty body says nothing, and what a missing snippet says is not known."""
    blocks, document = gathered(analysis), analysis.document
    for opener, closer in blocks.pairs:
        if opener.bracket.kind != "loop" or Foreign in (type(opener.bracket), type(closer.bracket)):
            continue
        first, stop = opener.line + 1, closer.line
        for name, token in dict(counters(document.node(opener.line))).items():
            used = _brought(blocks, name, first, stop) or _named(document, name, first, stop)
            if not used and any(document.line(line).strip() for line in range(first, stop)):
                message = f"no line of the loop refers to `|{name}|`, so every pass is the same"
                yield Report(Span(token.start, token.end), message, opener.line)


def _brought(blocks: Gathered, name: str, first: int, stop: int) -> bool:
    """Whether a snippet in the body refers to the name, or may do so."""
    for line, _ in blocks.files[bisect_left(blocks.files, first, key=lambda file: file[0]) :]:
        if line >= stop:
            return False
        effect = blocks.effects[line]
        if effect is None or not effect.sure or name in effect.names:
            return True
    return False


def _named(document: Document, name: str, first: int, stop: int) -> bool:
    """Whether a line of the program refers to the name."""
    line = first
    while line < stop:
        piece = document.piece(line)
        found = _names_of(piece.chunk).get(name, ())
        if any(first <= piece.line + index < stop for index in found):
            return True
        line = piece.line + max(piece.chunk.eols, 1)
    return False


def _names_of(chunk: Chunk) -> Mapping[str, list[int]]:
    """The names in a chunk with the lines in which they stand: kept with the chunk."""
    found: dict[str, list[int]] | None = chunk.memo.get(__name__)
    if found is None:
        found = chunk.memo[__name__] = {}
        for index in range(len(chunk.shapes)) if "|" in chunk.text else ():
            for _, name in names(chunk.line(index)):
                found.setdefault(name, []).append(index)
    return found
