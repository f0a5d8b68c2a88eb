"""Call of a program that there is not.

GOPn runs program n of the memory: a file `n.*` in the folder of the setting `cmos-dir`, or a
section `:n` of a file there. Where no folder is set, it is a section of the same file, if that
has any.

Source: spec/z32.md §6.4, §11

Bad:

    !GOP9!
        ^
    :1

Bad (cmos-dir=cmos):

    !GOP9!
        ^
    !GOP<4-1>!
    !GOP4!
    -- cmos/3.z32 --
    G26
    -- cmos/all.z32 --
    :4
    G26

Good:

    !GOP9!
    !GOP<HA>!
    :9
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.z32._program import beside, called, lines
from deburr.rules.z32._stores import programs, sections_in
from deburr_grammar.text import Span


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number. A folder that is empty or cannot be seen, and a file without sections, decide nothing."""
    calls = list(lines(analysis, "call"))
    folder = analysis.settings["cmos-dir"] if calls else ""
    for at, node in calls:
        line = Line(node, analysis.settings)
        for call in node.find("call"):
            number, part = called(line, call), call.children[1]
            store = f"{folder}-temp" if folder and call.children[0].kind == "GOS" else folder
            known = programs(analysis.host, beside(analysis, store)) if store else sections_in(analysis.document.text)
            if number is not None and known and number not in known:
                place = f"in `{store}`" if store else "in this file (setting `cmos-dir` names a folder)"
                yield Report(
                    Span(part.start, part.end),
                    f"there is no program {number} {place}; the control stops at this call",
                    at,
                )
