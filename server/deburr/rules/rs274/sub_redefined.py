"""Subprogram defined twice.

Each subprogram of a file has a label of its own; the control stops with "redefining sub".

Source: spec/rs274.md §6

Bad:

    o1 sub
    o1 endsub
    o1 sub
    ^^^^^^
    o1 endsub

Good:

    o1 sub
    o1 endsub
    o<one> sub
    o<one> endsub
    o1 call
    o<one> call
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from deburr.blocks import ready
from deburr.rule import Report, Severity, Whole, rule
from deburr.rules.rs274._o_words import note, said
from deburr_grammar.structure import Placed

if TYPE_CHECKING:
    from deburr.analysis import Analysis


@rule(Severity.ERROR, Whole(ready))
def check(analysis: "Analysis") -> Iterator[Report]:
    """Report every definition but the first of each label."""
    first: dict[str, Placed] = {}
    for scope in analysis.scopes:
        if scope.start is None or scope.start.bracket.label is None:
            continue
        earlier = first.setdefault(scope.start.bracket.label, scope.start)
        if earlier is not scope.start:
            message = f"{said(scope.start.bracket)} defines a subprogram a second time; the control refuses it"
            yield Report(scope.start.bracket.span, message, scope.start.line, (note(earlier, "is the first"),))
