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

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import template_of
from deburr.templates.items import words_in
from deburr.templates.symbols import is_free
from deburr.templates.template import Template


@rule(Severity.INFO, Whole(), default=False)
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first setting of each word."""
    template = template_of(analysis)
    own = frozenset(_of_themselves(template))
    read = {
        use.spelled.name for use in template.uses if use.role not in _WITHOUT and (use.line, use.span.start) not in own
    }
    # A misspelt use is reported where it stands, and offers the word that is meant.
    read |= {
        template.symbols.nearest(use.said) for use in template.uses if use.spelled.kind in ("undeclared", "unknown")
    }
    read |= template.named_in_faults
    for use in template.uses:
        name = use.spelled.name
        if use.role == "target" and name not in read and (is_free(name) or name in template.symbols.declared):
            read.add(name)
            yield Report(
                use.span, f"`#{name}` is set and never read; is it spelled otherwise where it is read?", use.line
            )


_WITHOUT = ("target", "format", "declared")
"""What is done to a word without its value."""


def _of_themselves(template: Template) -> Iterator[tuple[int, int]]:
    """Where a word is read only to set it again: lines and columns."""
    for item, _, _ in template.of("eval"):
        words = list(words_in(item.node)) if item.node is not None else []
        said = [(template.text(item.line)[token.start + 1 : token.end], token, role) for token, role in words]
        targets = {name for name, _, role in said if role == "target"}
        yield from ((item.line, token.start) for name, token, role in said if role != "target" and name in targets)
