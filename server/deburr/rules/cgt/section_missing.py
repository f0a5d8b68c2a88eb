"""Call of a section that does not exist.

`#CALL` and `#GOTO` run a section of the same template. Without it nothing would be output
where the template counts on something.

Source: spec/cgt.md §5.5, §7

Bad:

    #CALL(TOOLCHNG)
          ^^^^^^^^

Bad:

    #IF(#V1>3)<#GOTO(DWELL)>
                     ^^^^^

Bad:

    @DECLARE
    #CALCDEC #side
             ^^^^^
    @
    @DWELL
    #side

Good:

    #CALL(TOOLCHG)
    #CALL(spindle)
    @
    @spindle
    S#SPEED M03
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import missing, similar_section
from deburr.rules.cgt._template import ready, template_of


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name that leads nowhere."""
    template = template_of(analysis)
    names = {section.name for section in template.sections}
    for name, line, span, word in missing(template):
        purpose = f"to compute `#{word}`" if word else "to run"
        yield Report(span, f"there is no section `@{name}` {purpose}{similar_section(name, names)}", line)


fix = did_you_mean
