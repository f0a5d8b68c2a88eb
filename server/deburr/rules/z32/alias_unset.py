"""AA, AB or AC without G25.

They stand for the axes that the last G25 named; without one the control does not know which axis
to move, and stops. Reported is the first use in a program that certainly has no G25 before it.

Source: spec/z32.md §6.5

Bad:

    AA1
    ^^

Bad:

    AB1 G25XYZ AC2
    ^^

Bad:

    S1500 M3
    G0 AA10 AB20
       ^^
    G25XYZ
    G0 AC2

Good:

    G25XYZ
    S1500 M3
    G0 AA10 AB20
    G0 AC2
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import is_main, lines, ready_jumps


@rule(Severity.ERROR, Whole(ready_jumps))
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first use, where no G25 can have come before: neither by a jump nor in a program that is called."""
    used = next(lines(analysis, "alias_name"), None)
    if used is None or not is_main(analysis) or next(lines(analysis, "call", "file_call"), None) is not None:
        return
    first = _first_alias(analysis)
    if first is not None and next(lines(analysis, "jump"), None) is not None:
        return
    line, node = used
    name = next(node.find("alias_name"))
    if first is None or (line, name.start) < first:
        said = node.text[name.start : name.end].upper()
        yield Report(whole(name), f"`{said}` stands for no axis yet: `G25` must name three before", line)


def _first_alias(analysis: Analysis) -> tuple[int, int] | None:
    for line, node in lines(analysis, "axis_alias"):
        return line, next(node.find("axis_alias")).start
    return None
