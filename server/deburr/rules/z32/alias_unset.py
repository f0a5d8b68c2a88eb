"""AA, AB or AC without G25.

They stand for the axes that the last G25 named; without one the control does not know the axis.

Source: spec/z32.md §6.5

Bad:

    AA1
    ^^

Bad:

    AB1 G25XYZ AC2
    ^^

Good:

    G25XYZ AA1
    AB2
"""

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import is_main, lines


@rule(Severity.ERROR, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first use of each name, where no G25 can have come before: neither by a jump nor in a program that is called."""
    uses = next(lines(analysis, "alias_name"), None)
    if uses is None or not is_main(analysis) or next(lines(analysis, "call", "file_call"), None) is not None:
        return
    first = _first_alias(analysis)
    if first is not None and next(lines(analysis, "jump"), None) is not None:
        return
    seen = set()
    for line, node in lines(analysis, "alias_name"):
        for name in node.find("alias_name"):
            said = node.text[name.start : name.end].upper()
            if said not in seen and (first is None or (line, name.start) < first):
                seen.add(said)
                yield Report(whole(name), f"`{said}` stands for no axis yet: `G25` must name three before", line)


def _first_alias(analysis: Analysis) -> tuple[int, int] | None:
    for line, node in lines(analysis, "axis_alias"):
        return line, next(node.find("axis_alias")).start
    return None
