"""Restoring a modal state that was never saved.

`M72` brings back what `M70` or `M73` has saved at the same call level. Without one before it the control
stops with "Cannot restore context from invalid stack frame - missing M70/M73?".

Other words are best written on lines of their own: where `M72` brings a mode back, the control forgets the moves, G codes and even
the `M2` beside it. Only F, S, T, G93 to G97, M6 and M61 to M68 act before.

Source: spec/rs274.md §5

Bad:

    G91
    M72
    ^^^

Good:

    M70
    G91
    M72
"""

from collections.abc import Iterator

from deburr.modal import State
from deburr.rule import Line, Modal, Report, Severity, rule
from deburr.rules.rs274._words import report, said, words

_SAVED = "SAVED"
"""A group that nothing sets: it is untouched as long as nothing was saved, restored or called."""


@rule(Severity.ERROR, Modal(("word",)))
def check(line: Line, state: State) -> Iterator[Report]:
    """Report the code."""
    found = words(line)
    if "M72" in found.has and state.untouched(_SAVED):
        at = found.first("M72")
        yield report(line, at, f"`{said(line, at)}` restores a state that no `M70` or `M73` has saved before it")
