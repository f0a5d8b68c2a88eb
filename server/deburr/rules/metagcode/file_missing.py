"""Snippet that is not there.

The file is looked for in the folder of snippets, with exactly this name: no extension is added. It
is read even inside an `#IF` that is false, because snippets are put in first.

Source: spec/metagcode.md §1, §4, §6, §10

Bad:

    #FILE nothere.txt
          ^^^^^^^^^^^

Bad:

    #IF1 no equalto yes a
    #FILE drill
          ^^^^^
    #ENDIF1
    #FILE MILL.TXT
          ^^^^^^^^
    -- Snippets/drill.txt --
    G81 X0 Y0 Z-5 R2
    -- Snippets/mill.txt --
    G1 X0
    -- Snippets/Mill.txt --
    G1 X1

Good (snippets-dir=parts):

    #FILE drill.txt
    -- parts/drill.txt --
    G81 X0 Y0 Z-5 R2
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered
from deburr.rules.metagcode._library import Library
from deburr.suggest import suggestion


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name."""
    blocks = gathered(analysis)
    for line, span, name, found in blocks.named:
        if found is None:
            root = blocks.library.root
            yield Report(span, f"`{name}` is not in the folder of snippets `{root}`{_hint(blocks.library, name)}", line)


def _hint(library: Library, name: str) -> str:
    last = name.replace("\\", "/").rpartition("/")[2]
    alike = [each for each in library.near(name) if each.casefold() == last.casefold()]
    if len(alike) > 1:
        return f"; {' and '.join(f'`{each}`' for each in alike)} differ from it in case, and neither is preferred"
    return suggestion(last, library.near(name))
