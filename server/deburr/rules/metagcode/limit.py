"""Text that grows beyond a limit.

Blocks may be nested 200 deep in the text with all its snippets put in, a snippet may have 1 MiB,
and that text 1,000,000 lines; a loop may make 100,000 passes, and all together 1,000,000. No real
program comes near; a chain of snippets that include each other several times does, or a step that
is a thousand times too small.

Source: spec/metagcode.md §6, §7, §10

Bad:

    G0 Z5
    #FILE a.txt
    ^^^^^^^^^^^
    -- Snippets/a.txt --
    #FILE b.txt
    #FILE b.txt
    #FILE b.txt
    #FILE b.txt
    #FILE b.txt
    #FILE b.txt
    -- Snippets/b.txt --
    #FILE c.txt
    #FILE c.txt
    #FILE c.txt
    #FILE c.txt
    #FILE c.txt
    #FILE c.txt
    -- Snippets/c.txt --
    #FILE d.txt
    #FILE d.txt
    #FILE d.txt
    #FILE d.txt
    #FILE d.txt
    #FILE d.txt
    -- Snippets/d.txt --
    #IF1 |a| equalto 1 n

Bad (variables=part.vars):

    #LOOP1 |Depth| .001 c
           ^^^^^^^
    G1 Z-|Depth|
    #ENDLOOP1
    -- part.vars --
    Depth=1000000000

Good:

    #IF1 |a| equalto 1 n
    #FILE d.txt
    #ENDIF1
    -- Snippets/d.txt --
    G0 X1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import Foreign, Gathered, gathered, ready
from deburr.steps import paced
from deburr_grammar.dialect import Role
from deburr_grammar.dialects.metagcode.limits import LARGEST, LINES, NESTED
from deburr_grammar.dialects.metagcode.outline import SNIPPET
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the line that goes beyond a limit."""
    blocks = gathered(analysis)
    yield from _nested(blocks)
    yield from _large(blocks)
    yield from _long(analysis, blocks)


def _nested(blocks: Gathered) -> Iterator[Report | None]:
    for visit in paced(blocks.visits()):
        if visit is None:
            yield None
            continue
        placed, around = visit
        bracket, depth = placed.bracket, len(around)
        effect = blocks.effects[placed.line] if bracket.kind == SNIPPET else None
        opens = bracket.role is Role.OPEN and not isinstance(bracket, Foreign)
        deepest = effect.deepest if effect is not None else int(opens)
        if depth <= NESTED < depth + deepest:
            yield Report(bracket.span, f"blocks are nested more than {NESTED} deep here, which is refused", placed.line)


def _large(blocks: Gathered) -> Iterator[Report]:
    for line, span, name, found in blocks.named:
        if found is not None and found.larger(LARGEST):
            yield Report(span, f"`{name}` has more than {LARGEST:,} bytes, which is refused for a snippet", line)


def _long(analysis: Analysis, blocks: Gathered) -> Iterator[Report]:
    document = analysis.document
    message = f"the text has more than {LINES:,} lines with all its snippets put in, which is refused"
    lines = document.line_count - 1
    if lines > LINES or (lines == LINES and document.line(lines)):
        yield Report(Span(0, max(len(document.line(LINES)), 1)), message, LINES)
        return
    lines += document.line(lines) != ""
    for line, bracket in blocks.files:
        effect = blocks.effects[line]
        lines += effect.lines - 1 if effect is not None else 0
        if lines > LINES:
            yield Report(bracket.span, message, line)
            return
