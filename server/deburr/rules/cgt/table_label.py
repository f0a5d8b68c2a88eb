"""Label that disagrees with its row.

What stands left of the comma is ignored: rows are counted from 0. A number there that is not the
row's own promises another row.

Source: spec/cgt.md §5.7

Bad:

    @COOLNT
    1,M09
    ^
    2,M08
    ^
    3,M07
    ^

Good:

    @COOLNT
    0,M09
    01,M08
    mist,M07
    ,M09
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.cgt._template import ready, template_of
from deburr_grammar.text import Span


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the label."""
    template = template_of(analysis)
    for section in template.sections:
        for index, row in enumerate(section.rows):
            if row.line in template.faulty_lines:
                continue
            label = row.node.find("LABEL")
            said = row.text[label.start : label.end].strip(" \t") if label else ""
            if label and re.fullmatch("[0-9]+", said) and said.lstrip("0") != str(index).lstrip("0"):
                span = Span(label.start, label.start + len(said))
                yield Report(
                    span, f"this is row {index}, not {said}; rows are counted from 0 and labels are ignored", row.line
                )


def fix(broken: Broken) -> Iterator[Fix]:
    """Write the number that the row has."""
    row = re.search(r"this is row ([0-9]+)", broken.finding.message)
    if row is not None:
        yield broken.replaced(row[1])
