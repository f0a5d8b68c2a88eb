"""Section that nothing in the template runs.

Its name is none that the generator runs by itself, no `#CALL` or `#GOTO` names it, and it is
no table. Or only sections call it that it calls itself, so that nothing comes to any of them. A user command in the model may
still call it; more often the name is misspelt and the section is silently left out. What is called from sections that run
is never called unreachable, wherever the calls stand, because the model may call it as well.

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

Bad:

    @
    @clean
    ^^^^^^
    #IF(#V1>0)<#CALL(blow)>
    @
    @blow
    M07
    #CALL(clean)
    @

Good:

    #CALL(change)
    @
    @change
    M06
    @
"""

from collections.abc import Iterator, Mapping, Set

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.fixers import did_you_mean
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._sections import computed, misspelt, misspelt_declare, similar_section
from deburr.rules.cgt._template import ready, template_of
from deburr.templates.template import Template, target
from deburr_grammar.dialects.cgt.outline import SECTIONS


@rule(Severity.INFO, Whole(ready))
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
    yield from _circles(template, used)


def _circles(template: Template, used: Set[str]) -> Iterator[Report]:
    """The first section of each circle of calls that nothing leads to."""
    calls: dict[str, set[str]] = {section.name: set() for section in template.sections}
    for call, section in template.calls():
        calls[section.name].add(target(call)[0])
    called = {name for caller, names in calls.items() for name in names if name != caller}
    # One that calls itself has a fault of its own.
    started = {name for name, names in calls.items() if name not in called or name in names}
    reached = _reached(calls, started | (used - called) | (SECTIONS & calls.keys()) | computed(template))
    for section in template.sections:
        if not (section.faulty or section.is_table or section.name in reached | template.named_in_faults):
            reached |= _reached(calls, {section.name})
            message = f"only sections call `@{section.name}` that it calls itself, so that nothing comes to any of them"
            yield Report(section.span, message, section.line)


def _reached(calls: Mapping[str, Set[str]], names: Set[str]) -> set[str]:
    """Some sections and all that they call."""
    found, waiting = set(names), list(names)
    while waiting:
        behind = calls.get(waiting.pop(), frozenset()) - found
        found |= behind
        waiting += behind
    return found


def fix(broken: Broken) -> Iterator[Fix]:
    """Spell it as it is meant, if there is none of that name yet."""
    taken = {scope.start.bracket.label for scope in broken.analysis.scopes if scope.start is not None}
    yield from (each for each in did_you_mean(broken) if each.edits[0].text.removeprefix("@") not in taken)
