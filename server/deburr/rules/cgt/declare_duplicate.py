"""Word that is declared twice.

It can have one type only, and which of two the generator takes is not documented.

Source: spec/cgt.md §7

Bad:

    @DECLARE
    #INT #depth
    #DEC #depth
         ^^^^^^

Bad:

    @DECLARE
    #INT #passes, #passes
                  ^^^^^^^

Good:

    @DECLARE
    #INT #passes
    #DEC #depth
    @
    @DWELL
    #REPEAT(#passes)<G01 Z#depth>
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.cgt._declared import undeclared
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.items import Declaration


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report every declaration but the first."""
    first: dict[str, Declaration] = {}
    for each in template_of(analysis).declarations:
        if each.inside:
            known = first.setdefault(each.name, each)
            if known is not each:
                note = Note(known.line, known.span, f"declared here as `#{known.command}`")
                yield Report(each.span, f"`#{each.name}` is declared already; a word has one type", each.line, (note,))


def fix(broken: Broken) -> Iterator[Fix]:
    """Take the second one out of the list."""
    yield from undeclared(broken)
