"""Snippet that is found only by ignoring case.

On Windows `DRILL.TXT` and `drill.txt` are one file; elsewhere they are two, and the snippet is not
found once the template is moved there. If several files differ in case only, none of them is taken.

Source: spec/metagcode.md §6, §10

Bad:

    #FILE DRILL.TXT
          ^^^^^^^^^
    #FILE mill/a.txt
          ^^^^^^^^^^
    -- Snippets/drill.txt --
    G81 X0 Y0 Z-5 R2
    -- Snippets/Mill/a.txt --
    G1 X0

Good:

    #FILE drill.txt
    -- Snippets/drill.txt --
    G81 X0 Y0 Z-5 R2
    -- Snippets/DRILL.TXT --
    G83 X0 Y0 Z-5 R2 Q1
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import corrected, safe
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered, ready


@rule(Severity.WARNING, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name."""
    blocks = gathered(analysis)
    for line, span, name, found in blocks.named:
        if found is not None and not found.exact:
            spelled = found.path.removeprefix(f"{blocks.library.root}/")
            yield Report(
                span, f"`{name}` is spelled `{spelled}` in the folder; where case counts it is not found", line
            )


fix = safe(corrected)
