"""Configured value with a bar in it.

Values are filled in once and not looked at again, so a bar in one would go to the control, which
has no use for it. It is an error in the file of values, whether the variable is used or not; in the
program its first use is marked, or the first line if there is none.

Source: spec/metagcode.md §5.2, §6, §10

Bad (variables=part.vars):

    (part |Name|)
          ^^^^^^
    G0 X|Name|
    -- part.vars --
    Name=plate|4

Bad (variables=part.vars):

    G0 X0
    ^^^^^
    G1 X|Length|
    -- part.vars --
    Length=120.5
    Offset=|Length|

Good (variables=part.vars):

    (part |Name|)
    -- part.vars --
    Name=plate/4
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._variables import bad_values

_BAR = re.compile(r"\|")


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report each such value once."""
    for bad in bad_values(analysis, _BAR):
        message = f"the value `{bad.value}` of `|{bad.name}|` has a bar in it, and values are not filled in again; write it in `{bad.file}` without bars"
        yield Report(bad.span, message, bad.line, (bad.note,))
