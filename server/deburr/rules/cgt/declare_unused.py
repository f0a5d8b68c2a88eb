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
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import Template, template_of


@rule(Severity.INFO, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the declaration."""
    template = template_of(analysis)
    used = {use.spelled.name for use in template.uses if use.role not in ("declared", "macro")}
    times = Counter(each.name for each in template.declarations)
    for each in template.declarations:
        known = each.name in template.symbols.declared and times[each.name] == 1
        if each.inside and known and each.name not in used and not _in_faulty(template, each.name):
            yield Report(each.span, f"`#{each.name}` is declared and never used", each.line)


def _in_faulty(template: Template, name: str) -> bool:
    """Whether a line that could not be read to its end names the word."""
    return any(f"#{name}" in node.text for _, node in template.lines if node.problems)
