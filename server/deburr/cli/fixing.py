"""Programs mended: `check --fix` and `--diff`. Writes nothing itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from deburr.analysis import Analysis
from deburr.check import opened
from deburr.mend import mended

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from deburr.cli.opening import Opening
    from deburr.finding import Finding
    from deburr.host import Host
    from deburr.inputs import Inputs
    from deburr.ruleset import RuleSet
    from deburr.source import Source
    from deburr_grammar.document import Document


class Fixed(NamedTuple):
    """A program behind its fixes, and how many findings they took away."""

    source: Source
    taken: int


def fixed(
    opening: Opening,
    ruleset: RuleSet,
    host: Host,
    run: Callable[[Analysis], Iterable[Finding | None]] | None,
    inputs: Inputs,
    *,
    unsafe: bool,
) -> Fixed:
    """The program with all fixes made that hold; ``unsafe``: also those that are a guess."""
    source, file = opening.source, opening.file

    def look(document: Document) -> Analysis:
        return Analysis(document, ruleset, file, host, tuple(source.notices()), run, inputs)

    done = mended(opened(source, opening.dialect, ruleset, host), look, unsafe=unsafe)
    return Fixed(source._replace(text=done.document.text), len(done.fixed)) if done.fixed else Fixed(source, 0)
