"""Table that does not exist.

`#TABLE`, the words of a `#TBL` and table words such as `#ADIR` print a row of the section of that
name, or of the machine file's `[tables]`. Without it nothing is output, and a code may be missing from
the program. Most system words have codes of their own: `#MOV` prints G00 to G03.

Source: spec/cgt.md §5.7

Bad:

    #TABLE(gears, 1)
           ^^^^^

Bad:

    @DECLARE
    #TBL #gear
         ^^^^^
    @
    @DWELL
    #gear

Bad:

    #ADIR
    ^^^^^

Good:

    #MOV #COOLNT
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

from collections.abc import Iterator, Sequence

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, parted, rule
from deburr.rules.cgt._sections import similar_section
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.symbols import rows_of
from deburr.templates.template import Template, Use, target


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report the name."""
    template = template_of(analysis)
    tables = {section.name for section in template.sections if section.is_table} | template.machine.tables.keys()
    for item, _, _ in template.of("lookup"):
        if (named := target(item))[0] not in tables:
            hint = similar_section(named[0], {section.name for section in template.sections})
            yield Report(named[1], f"there is no table `@{named[0]}`, so nothing is output{hint}", item.line)
    names = {section.name for section in template.sections}
    for each in template.declarations:
        if each.command == "TBL" and each.inside and each.name not in tables and each.name in template.symbols.declared:
            yield Report(each.span, _empty(each.name, names), each.line)

    def of(uses: Sequence[Use]) -> Iterator[Report]:
        for use in uses:
            name = use.spelled.name
            if use.role == "output" and _prints_rows(template, name) and name not in tables and not rows_of(name):
                yield Report(use.span, _empty(name, names), use.line)

    yield from parted(template.uses, of)


def _prints_rows(template: Template, name: str) -> bool:
    """Whether a name is a table word that the template does not declare itself."""
    word = None if template.machine.lost or name in template.symbols.declared else template.symbols.system(name)
    return word is not None and word.type == "table"


def _empty(name: str, names: set[str]) -> str:
    return f"there is no table `@{name}`, so `#{name}` outputs nothing{similar_section(name, names)}"
