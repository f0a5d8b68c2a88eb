"""Configured value with a line end in it.

It would make two lines of G-code out of one, and the second one might move the machine. Only a JSON
file can hold such a value, as `\\n` or `\\r`. It is an error whether the variable is used or not; in
the program its first use is marked, or the first line if there is none.

Source: spec/metagcode.md §5.2, §10

Bad (variables=part.json):

    (part |Note|)
          ^^^^^^
    G0 X|Length|
    -- part.json --
    {"Length": 120.5, "Note": "plate\\nM3 S9000"}

Good (variables=part.json):

    (part |Note|)
    G0 X|Length|
    -- part.json --
    {"Length": 120.5, "Note": "plate, second side"}
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._variables import bad_values

_LINE_END = re.compile(r"[\r\n]")


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report each such value once."""
    for bad in bad_values(analysis, _LINE_END):
        first = _LINE_END.split(bad.value)[0]
        where = f"behind `{first}`" if first else "at its start"
        message = f"the value of `|{bad.name}|` has a line end {where}, which would make two lines of G-code out of one; write it in `{bad.file}` on one line"
        yield Report(bad.span, message, bad.line, (bad.note,))
