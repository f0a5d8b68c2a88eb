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
from collections.abc import Set as AbstractSet
from functools import cache

from deburr.analysis import Analysis
from deburr.finding import Fix
from deburr.fix import Broken
from deburr.includes.z32 import programs
from deburr.rule import Line, Report, Severity, Whole, rule
from deburr.rules.z32._program import beside, called, lines
from deburr_grammar.dialects.z32.forms import sections_in
from deburr_grammar.text import Edit, Pos, Span

_SHOWN = 4
"""Programs that a message names."""


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the number. A folder that is empty or cannot be seen, and a file without sections, decide nothing."""
    known = cache(lambda store: _known(analysis, store))
    for at, node in lines(analysis, "call"):
        line = Line(node, analysis.settings)
        folder = analysis.settings["cmos-dir"]
        for call in node.find("call"):
            number, part = called(line, call), call.children[1]
            store = f"{folder}-temp" if folder and call.children[0].kind == "GOS" else folder
            if number is not None and known(store) and number not in known(store):
                place = f"in `{store}`" if store else "in this file (setting `cmos-dir` names a folder)"
                message = f"there is no program {number} {place}, so the control stops at this call"
                yield Report(Span(part.start, part.end), f"{message}; {_choice(number, known(store))}", at)


def _known(analysis: Analysis, store: str) -> AbstractSet[int]:
    return programs(analysis.host, beside(analysis, store)) if store else sections_in(analysis.document.text)


def _choice(number: int, known: AbstractSet[int]) -> str:
    """The programs that there are, the nearest if they are many."""
    near = sorted(sorted(known, key=lambda each: abs(each - number))[:_SHOWN])
    return f"{'there is' if len(known) == 1 else 'there are' if len(known) == len(near) else 'the nearest are'} {', '.join(map(str, near))}"


def fix(broken: Broken) -> Iterator[Fix]:
    """An empty section of that number at the end, where sections of this file are what is called."""
    if "in this file" in broken.finding.message and broken.said.strip().isdigit():
        number, end = broken.said.strip(), broken.document.line_count - 1
        at = Pos(end, len(broken.document.line(end)))
        section = f"{chr(10) if at.col else ''}:{number}\nG26\n"
        yield Fix(f"Add the section `:{number}`", (Edit(at, at, section),))
