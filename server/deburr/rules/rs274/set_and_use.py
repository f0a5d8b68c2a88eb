"""Parameter that one line both sets and uses.

A line takes all its values before it sets anything: with #3=15, `#3=6 G1 X#3` moves to 15 and
leaves 6 in #3. That is legal and easily misread; a line of its own for the setting is clear.

Source: spec/rs274.md §4.3

Bad:

    #3=15
    #3=6 G0 X#3
             ^^

Good:

    #3=15
    #3=[#3+1] G0 X1
    G0 X#3
"""

from collections.abc import Iterator
from itertools import groupby

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.rs274._held import Role
from deburr.rules.rs274._names import names_of, ready_names
from deburr.rules.rs274._program import Use, program_of
from deburr.steps import paced


@rule(Severity.INFO, Whole(ready_names))
def check(analysis: Analysis) -> Iterator[Report | None]:
    """Report reads outside of the parameter's own new value. Where it had no value before, `named-undefined` speaks."""
    undefined = {(use.line, use.span) for use in names_of(analysis).undefined}
    for group in paced(groupby(program_of(analysis).uses, key=lambda use: use.line)):
        if group is None:
            yield None
            continue
        line, held = group[0], list(group[1])
        sets = {_key(use): use for use in held if use.role is Role.SET}
        for use in held if sets else ():
            found = sets.get(_key(use)) if use.role is Role.READ and _key(use) != (None, None) else None
            if found is None or (line, use.span) in undefined or _inside(use, found):
                continue
            said = analysis.document.line(line)[use.span.start : use.span.end]
            message = f"`{said}` has its old value here; the setting on this line takes effect behind it"
            yield Report(use.span, message, line, (Note(line, found.span, "the setting"),))


def _key(use: Use) -> tuple[str | None, int | None]:
    return use.name, use.number


def _inside(use: Use, setting: Use) -> bool:
    return setting.extent.start <= use.span.start < setting.extent.end
