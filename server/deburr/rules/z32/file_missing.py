"""Call of a file that there is not.

`:L254-` runs a file below the file root (setting `file-root`). The control stops when it does
not find it.

Source: spec/z32.md §6.4

Bad (file-root=icamfs):

    !:L254-NO\\FILE!
           ^^^^^^^
    -- icamfs/FOLDER/FILE --
    G26

Good (file-root=icamfs):

    !:L254-FOLDER\\FILE!
    -- icamfs/FOLDER/FILE --
    G26
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.fixers import did_you_mean
from deburr.includes.z32 import found_files, nearest_file
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.z32._program import beside, lines
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the path. Without a file root, or one that is empty or cannot be seen, nothing is certain."""
    root = str(analysis.settings["file-root"])
    calls = list(lines(analysis, "file_call")) if root else []
    if not calls or not analysis.host.names(beside(analysis, root)):
        return
    for at, node in calls:
        for call in node.find("file_call"):
            path = call.children[1]
            said = node.text[path.start : path.end]
            if ".." not in said and not found_files(analysis.host, beside(analysis, root), said):
                near = nearest_file(analysis.host, beside(analysis, root), said)
                hint = f"; did you mean `{near}`?" if near else ""
                message = f"there is no file `{said}` below `{root}`; the control stops at this call{hint}"
                yield Report(Span(path.start, path.end), message, at)


fix = did_you_mean
