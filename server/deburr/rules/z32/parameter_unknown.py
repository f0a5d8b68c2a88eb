"""Two-letter name that is no parameter of the control.

User parameters are HA to HZ. Other names exist only where the machine knows them; one that it
does not know is refused. `ADD_VAR_SYST_SPEC` declares a name of the machine.

Source: spec/z32.md §5

Bad:

    !QQ=1!
     ^^
    X<QQ+SZ>
         ^^

Good:

    A=$FCEPP('ADD_VAR_SYST_SPEC','QQ',0)
    !QQ=1; HA=1; LX=1; AE=1!
"""

import re
from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import lines

_ADDED = re.compile(r"'ADD_VAR_SYST_SPEC'[ \t]*,[ \t]*'([^'\n]*)'", re.I)


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first use of each name. A word between `!` and `!` is at fault as a whole."""
    seen: set[str] = set()
    declared: set[str] | None = None
    for line, node in lines(analysis, "other"):
        declared = _declared(analysis) if declared is None else declared
        moved = [(part.start, part.end) for part in node.find("movement")]
        for other in node.find("other"):
            name = node.text[other.start : other.end].upper()
            if name not in seen | declared and not any(start <= other.start < end for start, end in moved):
                seen.add(name)
                message = (
                    f"`{name}` is no user parameter (HA to HZ) and nothing declares it; a control that lacks it stops"
                )
                yield Report(whole(other), message + _hint(name, declared), line)


def _hint(name: str, declared: set[str]) -> str:
    """The letters the other way round, or a known name with one letter in common in its place."""
    if name[1] == "H":
        return f"; did you mean `H{name[0]}`?"
    known = sorted({"LX", "AE", *(each for each in declared if len(each) == len(name))})
    alike = [each for each in known if each == name[::-1] or each[0] == name[0] or each[1] == name[1]]
    return f"; did you mean `{alike[0]}`?" if len(alike) == 1 else ""


def _declared(analysis: Analysis) -> set[str]:
    """The names that are added to those of the system, be it in the text before the program: an emulator may read it there."""
    return {name.upper() for name in _ADDED.findall(analysis.document.text)}
