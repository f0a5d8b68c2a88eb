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
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._declared import undeclared
from deburr.rules.cgt._template import template_of


@rule(Severity.INFO, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the declaration."""
    template = template_of(analysis)
    uses = [use for use in template.uses if use.role not in ("declared", "macro")]
    used = {use.spelled.name for use in uses}
    # A misspelt use is reported where it stands, and offers the declared name.
    used |= {template.symbols.nearest(use.said) for use in uses if use.spelled.kind in ("undeclared", "unknown")}
    times = Counter(each.name for each in template.declarations)
    for each in template.declarations:
        known = each.name in template.symbols.declared and times[each.name] == 1
        if each.inside and known and each.name not in used | template.named_in_faults:
            yield Report(each.span, f"`#{each.name}` is declared and never used", each.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Take it out of the list."""
    yield from undeclared(broken)
