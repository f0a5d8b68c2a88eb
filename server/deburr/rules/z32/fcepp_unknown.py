"""`$` function that there is not.

`$FCEPP` sets up the emulator with 'SET_FILEROOT', 'ADD_VAR_SYST_SPEC' or 'INIT_VAR_SYST'; anything
else configures nothing.

Source: spec/z32.md §6.6

Bad:

    $FCEPP('X')
           ^^^
    A=$FCEPP('INIT_VARS')
             ^^^^^^^^^^^
    A=$FCEP('INIT_VAR_SYST')
      ^^^^^

Good:

    A=$FCEPP('INIT_VAR_SYST')
    A=$FCEPP('SET_FILEROOT','C:\\TEST',0)
"""

from collections.abc import Iterator
from difflib import get_close_matches

from deburr.fixers import did_you_mean
from deburr.rule import Line, Nodes, Report, Severity, rule
from deburr_grammar.text import Span
from deburr_grammar.tree import Node

_FUNCTIONS = ("SET_FILEROOT", "ADD_VAR_SYST_SPEC", "INIT_VAR_SYST")


@rule(Severity.ERROR, Nodes(("config",)))
def check(line: Line, node: Node) -> Iterator[Report]:
    """Report the name that is not known."""
    dollar, first = node.find("DOLLAR"), node.find("STRING")
    assert dollar is not None
    if line.said(dollar).upper() not in ("$FCEPP", "$FECPP"):
        yield Report(Span(dollar.start, dollar.end), f"`{line.said(dollar)}` is not known; did you mean `$FCEPP`?")
        return
    name = line.said(first).strip("'") if first else ""
    if name.upper() not in _FUNCTIONS:
        near = get_close_matches(name.upper(), _FUNCTIONS, 1)
        hint = f"did you mean '{near[0]}'?" if near else f"there are {', '.join(_FUNCTIONS)}"
        part = first or node
        yield Report(Span(part.start, part.end), f"`{line.said(part)}` names nothing that can be set up; {hint}")


fix = did_you_mean
