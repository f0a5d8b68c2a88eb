"""Assignment to something that cannot be set.

`#EVAL` sets words. A number, a name without `#`, a constant such as `#ON`, a text that the
generator makes such as `#DATE`, or a word that its own section computes cannot be set.

Source: spec/cgt.md §4, §7

Bad:

    #EVAL(3=#V1)
          ^
    #EVAL(#DATE=1)
          ^^^^^
    #EVAL(V1=3)
          ^^
    #EVAL(#ON=0)
          ^^^
    #EVAL(#IF=0)
          ^^^

Bad:

    @DECLARE
    #CALCDEC #side
    @
    @$side
    #RETNUM(1)
    @
    @DWELL
    #EVAL(#side=2)
          ^^^^^

Good:

    #EVAL(#FEED=#FEED*0.5)
    #EVAL(#ABSI=1)
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Item
from deburr.templates.template import Placed, Template, Use
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the target."""
    template = template_of(analysis)
    yield from parted(template.of("eval"), partial(_of_items, template))
    yield from parted(template.uses, _of_uses)


def _of_items(template: Template, items: Sequence[Placed]) -> Iterator[Report]:
    for item, _, _ in items:
        if (token := _no_word(item)) is not None:
            said = item.text[token.start - item.start : token.end - item.start]
            hint = f"; did you mean `#{said}`?" if template.symbols.find(said) else ""
            yield Report(token, f"`{said}` is no word, so nothing can be stored in it{hint}", item.line)


def _of_uses(uses: Sequence[Use]) -> Iterator[Report]:
    for use in uses:
        word = use.spelled.word
        if use.role == "target" and (
            use.spelled.kind in ("command", "class") or (word is not None and not word.settable)
        ):
            yield Report(use.span, f"`#{use.said}` cannot be set; assign to a word of your own", use.line)


def _no_word(item: Item) -> Span | None:
    assert item.node is not None
    token = item.node.children[2]
    return None if token.kind == "WORD" else Span(token.start, token.end)


fix = did_you_mean
