"""Word that is set and never read.

What `#EVAL` gives the word is never output, tested or computed with, other than to set the word itself. Often the name is spelled
otherwise where it is read, or the line that output it is gone. Nothing is said of the system's words, which the generator reads,
of words of macros, nor of a word that some line names that cannot be read to its end. It is not among the rules that speak unless asked to, because
a template is often worked on by parts: what a word is set for may not be written yet.

Source: spec/cgt.md §4, §5.1

Bad:

    #EVAL(#V1=#ZPOS-2)
          ^^^
    Z#V2
    #EVAL(#V2=5)

Bad:

    @
    @DECLARE
    #INT #holes
    @
    @FXD1
    #EVAL(#holes=#holes+1)
          ^^^^^^
    X#XPOS Y#YPOS

Good:

    #EVAL(#V1=#ZPOS-2)
    Z#V1
    #EVAL(#FEED=#FEED*2)
    #EVAL(#V3=#V3+1)
    #IF(#V3>10)<M00#EVAL(#V3=0)>
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import words_in
from deburr.templates.symbols import is_free
from deburr.templates.template import Placed, Template, Use


@rule(Severity.INFO, Whole(ready), default=False)
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the first setting of each word."""
    template = template_of(analysis)
    own: set[tuple[int, int]] = set()
    yield from parted(template.of("eval"), lambda items: own.update(_of_themselves(template, items)))
    read = set(template.named_in_faults)

    def take(uses: Sequence[Use]) -> None:
        taken = [use for use in uses if use.role not in _WITHOUT and (use.line, use.span.start) not in own]
        read.update([use.spelled.name for use in taken])
        # A misspelt use is reported where it stands, and offers the word that is meant.
        misspelt = [use.said for use in uses if use.spelled.kind in ("undeclared", "unknown")]
        read.update([template.symbols.nearest(said) for said in misspelt])

    yield from parted(template.uses, take)
    yield from parted(template.uses, partial(_of, template, read))


def _of(template: Template, read: set[str], uses: Sequence[Use]) -> Iterator[Report]:
    for use in uses:
        name = use.spelled.name
        if use.role == "target" and name not in read and (is_free(name) or name in template.symbols.declared):
            read.add(name)
            yield Report(
                use.span, f"`#{name}` is set and never read; is it spelled otherwise where it is read?", use.line
            )


_WITHOUT = ("target", "format", "declared")
"""What is done to a word without its value."""


def _of_themselves(template: Template, items: Sequence[Placed]) -> Iterator[tuple[int, int]]:
    """Where a word is read only to set it again: lines and columns."""
    for item, _, _ in items:
        words = list(words_in(item.node)) if item.node is not None else []
        said = [(template.text(item.line)[token.start + 1 : token.end], token, role) for token, role in words]
        targets = {name for name, _, role in said if role == "target"}
        yield from ((item.line, token.start) for name, token, role in said if role != "target" and name in targets)
