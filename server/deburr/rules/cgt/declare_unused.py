"""Declared word that nothing uses.

Often the sign of a misspelt name elsewhere.

Source: spec/cgt.md §7

Bad:

    @DECLARE
    #INT #passes, #depth
         ^^^^^^^
    @
    @DWELL
    #depth

Good:

    @DECLARE
    #INT #passes
    @
    @DWELL
    #REPEAT(#passes)<M08>
"""

from collections import Counter
from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._declared import undeclared
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import Use


@rule(Severity.INFO, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the declaration."""
    template = template_of(analysis)
    used: set[str] = set()

    def take(uses: Sequence[Use]) -> None:
        spelled = [(use.spelled, use.said) for use in uses if use.role not in ("declared", "macro")]
        used.update([each.name for each, _ in spelled])
        # A misspelt use is reported where it stands, and offers the declared name.
        used.update([template.symbols.nearest(said) for each, said in spelled if each.kind in _MISSPELT])

    yield from parted(template.uses, take)
    times = Counter(each.name for each in template.declarations)
    for each in template.declarations:
        known = each.name in template.symbols.declared and times[each.name] == 1
        if each.inside and known and each.name not in used | template.named_in_faults:
            yield Report(each.span, f"`#{each.name}` is declared and never used", each.line)


_MISSPELT = ("undeclared", "unknown")


def fix(broken: Broken) -> Iterator[Fix]:
    """Take it out of the list."""
    yield from undeclared(broken)
