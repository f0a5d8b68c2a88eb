"""User word that is not declared.

A name with a lower-case letter is a word of the template's own, and those are declared in
`@DECLARE`. For one that is not, SmartCAM asks its macro system, which knows nothing of it.

Source: spec/cgt.md §5.1, §11, *Words*

Bad:

    #EVAL(#myX=1)
          ^^^^

Bad:

    @DECLARE
    #DEC #cut_power
    @
    @DWELL
    S#cut_powr F#Feed_rate
     ^^^^^^^^^  ^^^^^^^^^^
    #EVAL(#cut_power=#F_Decimal)
                     ^^^^^^^^^^

Good:

    @DECLARE
    #DEC #cut_power
    @
    @DWELL
    #EVAL(#cut_power=1000)
    S#cut_power
"""

from collections.abc import Iterator, Sequence
from functools import partial

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.symbols import commands, format_classes
from deburr.templates.template import Template, Use


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the word."""
    template = template_of(analysis)
    yield from parted(template.uses, partial(_of, template))


def _of(template: Template, uses: Sequence[Use]) -> Iterator[Report]:
    for use in uses:
        if _asked(use) and use.spelled.kind == "undeclared" and use.said not in template.presumed:
            hint = template.symbols.similar(use.said, format_classes() if use.role == "format" else commands())
            yield Report(use.span, f"`#{use.said}` is not declared; declare it in `@DECLARE`{hint}", use.line)
        elif use.spelled.kind == "class" and use.role in ("output", "argument"):
            yield Report(use.span, f"`#{use.said}` is a class of formats and no word; only `#FMT` takes it", use.line)


def _asked(use: Use) -> bool:
    return use.role not in ("macro", "declared")


fix = did_you_mean
