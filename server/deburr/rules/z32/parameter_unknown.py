"""Two-letter name that is no parameter of the control.

User parameters are HA to HZ. Other names exist only where the machine knows them; one that it
does not know is refused. `ADD_VAR_SYST_SPEC` declares a name.

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

from collections.abc import Iterator

from deburr.analysis import Analysis
from deburr.rule import Report, Severity, Whole, rule, whole
from deburr.rules.z32._program import lines
from deburr_grammar.tree import Token


@rule(Severity.WARNING, Whole())
def check(analysis: Analysis) -> Iterator[Report]:
    """Report the first use of each name."""
    seen: set[str] | None = None
    for line, node in lines(analysis, "other"):
        seen = _declared(analysis) if seen is None else seen
        for other in node.find("other"):
            name = node.text[other.start : other.end].upper()
            if name not in seen:
                seen.add(name)
                message = (
                    f"`{name}` is no user parameter (HA to HZ) and nothing declares it; a control that lacks it stops"
                )
                yield Report(whole(other), message, line)


def _declared(analysis: Analysis) -> set[str]:
    """The names that the lines before the program add to those of the system."""
    names = set()
    for _, node in lines(analysis, "config"):
        for config in node.find("config"):
            strings = [part for part in config.children if isinstance(part, Token) and part.kind == "STRING"]
            names |= {node.text[part.start : part.end].strip("'").upper() for part in strings[1:2]}
    return names
