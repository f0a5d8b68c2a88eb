"""Table that does not exist.

`#TABLE` and the words of a `#TBL` print a row of the section of that name. Without it nothing is
output, and a code may be missing from the program.

Source: spec/cgt.md §5.7

Bad:

    #TABLE(nope, 1)
           ^^^^

Bad:

    @DECLARE
    #TBL #gear
         ^^^^^
    @
    @DWELL
    #gear

Good:

    #TABLE(gears, 1)
    @
    @gears
    0,M40
    1,M41

Good:

    @DECLARE
    #TBL#gear
    @
    @DWELL
    #gear
    @
    @gear
    0,M40
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import similar_section
from deburr.rules.cgt._template import target, template_of


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name."""
    template = template_of(analysis)
    tables = {section.name for section in template.sections if section.is_table} | template.machine_tables
    for item, _, _ in template.of("lookup"):
        if (named := target(item))[0] not in tables:
            hint = similar_section(named[0], {section.name for section in template.sections})
            yield Report(named[1], f"there is no table `@{named[0]}`, so nothing is output{hint}", item.line)
    for each in template.declarations:
        if each.command == "TBL" and each.inside and each.name not in tables and each.name in template.symbols.declared:
            yield Report(each.span, f"there is no table `@{each.name}`, so `#{each.name}` outputs nothing", each.line)
