"""Declaration of a name that is taken.

System words in any case, the words `#V0` to `#V99`, `#U0` to `#U99` and `#S0` to `#S99`, commands,
and classes of formats exist already.

Source: spec/cgt.md §4, §7

Bad:

    @DECLARE
    #INT #XPOS
         ^^^^^
    #DEC #V99,#if
         ^^^^
              ^^^
    #STR #feed, #F_Decimal
         ^^^^^
                ^^^^^^^^^^

Good:

    @DECLARE
    #INT #xOld, #V100
    @
    @DWELL
    #xOld #V100
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name."""
    template = template_of(analysis)
    for each in template.declarations:
        if each.inside and template.symbols.reserved(each.name):
            yield Report(
                each.span, f"`#{each.name}` exists already and cannot be declared; choose another name", each.line
            )
