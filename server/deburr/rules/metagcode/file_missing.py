"""Snippet that is not there.

The file is looked for in the folder of snippets, with exactly this name: no extension is added. The
folder is `Snippets` beside the program, unless the setting `snippets-dir` names another. The file is
read even inside an `#IF` that is false, because snippets are put in first.

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
from deburr.fixers import advised
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.metagcode._gathered import gathered, ready
from deburr.rules.metagcode._library import Library
from deburr.rules.metagcode._words import HINTED
from deburr.suggest import suggestion

_FOLDERS = 20
"""So many folders are looked into for a file that is not where it should be."""


@rule(Severity.ERROR, Whole(ready))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the name."""
    blocks = gathered(analysis)
    hints: dict[str, str] = {}
    for line, span, name, found in blocks.named:
        if found is None:
            if name not in hints and len(hints) < HINTED:
                hints[name] = _hint(blocks.library, name.replace("\\", "/"))
            hint = hints.get(name, "")
            yield Report(span, f"`{name}` is not in the folder of snippets `{blocks.library.root}`{hint}", line)


def _hint(library: Library, name: str) -> str:
    folder, slash, last = name.rpartition("/")
    near = library.near(name)
    if not slash and not near:
        return ", which is empty or not there; set `snippets-dir` to the folder that is meant"
    alike = [each for each in near if each.casefold() == last.casefold()]
    if last in near:
        return ", as far as it can be read: there is something of that name, and it is no file that has an end"
    if len(alike) > 1:
        return f"; {' and '.join(f'`{each}`' for each in alike)} differ from it in case, and neither is preferred"
    longer = [each for each in near if each.casefold().startswith(f"{last.casefold()}.")]
    if len(longer) == 1:
        return f"; no extension is added, write `{folder}{slash}{longer[0]}`"
    return suggestion(name, [f"{folder}{slash}{each}" for each in near]) or _elsewhere(library, name)


def _elsewhere(library: Library, name: str) -> str:
    """A file of that name in another folder, or where its path leads from beside the folder of snippets."""
    parts = name.split("/")
    inner = ["/".join(parts[at:]) for at in range(1, len(parts))]
    folders = [each for each in library.near("") if "." not in each][:_FOLDERS]
    found = [each for each in (*inner, *(f"{folder}/{parts[-1]}" for folder in folders)) if library.find(each)]
    return f"; did you mean `{found[0]}`?" if found else ""


fix = advised
