"""`#REPEAT` with a count that is no whole number from 0 on.

The count is an integer or a word that holds one. Nothing can be repeated a negative or a broken
number of times.

Source: spec/cgt.md §5.6

Bad:

    #REPEAT(-1)<M98 P100>
            ^^
    #REPEAT(1.5)<M98 P100>
            ^^^
    #REPEAT(#S1)<M08>
            ^^^
    #REPEAT(#V1+1)<M08>
            ^^^^^

Bad (input=sample.cl):

    #EVAL(#V1=#XPOS/2)
    #REPEAT(#V1)<M08>
            ^^^
    -- sample.cl --
    FEDRAT/200
    GOTO/1,0,0
    FINI

Good:

    #REPEAT(0)<M08>
    #REPEAT(#V1)<M08>
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.symbols import Symbols
from deburr.templates.template import Placed, Template
from deburr.templates.types import no_numbers
from deburr_grammar.text import Span
from deburr_grammar.tree import Node, Token


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the count."""
    template = template_of(analysis)
    yield from parted(template.of("repeat"), partial(_of, template))


def _of(template: Template, items: Sequence[Placed]) -> Iterator[Report]:
    for item, _, _ in items:
        assert item.node is not None
        text, count = template.text(item.line), item.node.children[2]
        if not _counts(template.symbols, text, count):
            said = text[count.start : count.end]
            message = f"`{said}` is no count; a whole number from 0 on, or a word that holds one, is needed"
            yield Report(Span(count.start, count.end), message, item.line)


def _counts(symbols: Symbols, text: str, count: Node | Token) -> bool:
    if count.kind == "WORD":
        return not any(True for _ in no_numbers(symbols, text, count))
    return count.kind == "NUMBER" and not text[count.start : count.end].partition(".")[2].strip("0")
