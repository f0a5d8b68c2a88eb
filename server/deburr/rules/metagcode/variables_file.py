"""Configured file of values that cannot be used.

The setting `variables` names a file with lines `name=value`, or a JSON object of names with texts
and numbers. Blank lines and lines that begin with `#` or `;` are passed over. If the file is not
there, or a line of it cannot be understood, or a name has two values, it is not known what would be
generated, and names without a value are not reported until it is mended.

Source: spec/metagcode.md §5.2

Bad (variables=part.vars):

    G0 X|Length|
    ^^^^^^^^^^^^

Bad (variables=part.vars):

    G0 X|Length|
    ^^^^^^^^^^^^
    -- part.vars --
    # plate, second side
    Width=40
    Length 120.5

Bad (variables=part.vars):

    G0 X|Length|
    ^^^^^^^^^^^^
    -- part.vars --
    Length=120.5
    Length=12.05

Bad (variables=part.json):

    G0 X|Length|
    ^^^^^^^^^^^^
    -- part.json --
    {"Length": 120.5,}

Good (variables=part.vars):

    G0 X|Length|
    -- part.vars --
    ; plate, second side
    Length = 120.5

Good (variables=part.json):

    G0 X|Length|
    -- part.json --
    {"Length": "120.5"}
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Note, Report, Severity, Whole, rule
from deburr.rules.metagcode._variables import configured, first_line


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report at the first line, once; what is wrong in the file are related places."""
    found = configured(analysis)
    if found is None:
        return
    if found.read is None:
        message = f"the file of values `{found.path}` cannot be read, so no variable has a value; correct the setting `variables`"
        yield Report(first_line(analysis), message, 0)
    elif found.read.defects:
        first, *more = found.read.defects
        others = f", and {len(more)} more" if more else ""
        message = f"line {first.line + 1} of the file of values `{found.name}` cannot be used: {first.why}{others}"
        notes = tuple(Note(each.line, each.span, each.why, found.path) for each in found.read.defects)
        yield Report(first_line(analysis), message, 0, notes)
