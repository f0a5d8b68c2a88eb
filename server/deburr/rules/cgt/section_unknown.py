"""Section that nothing in the template runs.

Its name is none that the generator runs by itself, no `#CALL` or `#GOTO` names it, and it is
no table. A user command in the model may still call it; more often the name is misspelt and
the section is silently left out.

Source: spec/cgt.md §1, §7

Bad:

    @
    @TOOLCHANGE
    ^^^^^^^^^^^
    M06
    @

Bad:

    @
    @$side
    ^^^^^^
    #RETNUM(1)
    @

Bad:

    @
    @DWEL
    ^^^^^
    G04 P#DWELL
    @

Good:

    #CALL(change)
    @
    @change
    M06
    @
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import computed, misspelt, misspelt_declare, similar_section
from deburr.rules.cgt._template import template_of
from deburr.templates.template import target
from deburr_grammar.dialects.cgt.outline import SECTIONS


@rule(Severity.INFO, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the header."""
    template = template_of(analysis)
    used = SECTIONS | {target(call)[0] for call, _ in template.calls()} | computed(template) | misspelt(template)
    used |= template.named_in_faults | {section.name for section in misspelt_declare(template)}
    for section in template.sections:
        if not (section.faulty or section.is_table or section.name in used):
            hint = similar_section(section.name, SECTIONS)
            message = f"`@{section.name}` is no section that the generator runs, and nothing here calls it{hint}"
            yield Report(section.span, message, section.line)


def fix(broken: Broken) -> Iterator[Fix]:
    """Spell it as it is meant, if there is none of that name yet."""
    taken = {scope.start.bracket.label for scope in broken.analysis.scopes if scope.start is not None}
    yield from (each for each in did_you_mean(broken) if each.edits[0].text.removeprefix("@") not in taken)
