"""A program's bytes to its findings, in places of the file. Never opens a file, never chooses a dialect."""

from collections.abc import Callable, Iterable

from deburr.analysis import Analysis
from deburr.finding import Finding, Place
from deburr.host import Host, NoFiles
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document


def check(
    source: Source,
    dialect: Dialect,
    ruleset: RuleSet,
    file: str = "",
    host: Host | None = None,
    run: Callable[[Analysis], Iterable[Finding | None]] | None = None,
    inputs: Inputs | None = None,
) -> list[Finding]:
    """All findings in order; with ``run`` (`deburr.ran`) also those that a run of the program meets."""
    document = opened(source, dialect, ruleset, host)
    findings = Analysis(document, ruleset, file, host, tuple(source.notices()), run, inputs).findings()
    return in_file(findings, file, source)


def opened(source: Source, dialect: Dialect, ruleset: RuleSet, host: Host | None = None) -> Document:
    """The program as a document that knows what its settings bring from other files."""
    return Document.parse(source.text, dialect, given=dialect.given(ruleset.settings, (host or NoFiles()).read))


def in_file(findings: list[Finding], file: str, source: Source) -> list[Finding]:
    """Findings in places of the text as findings in places of the file."""
    return [_in_file(finding, file, source.shift) for finding in findings] if source.shift else findings


def _in_file(finding: Finding, file: str, shift: int) -> Finding:
    """The finding where an editor shows it: what leads the program moves its first line."""
    related = tuple(each._replace(place=_moved(each.place, file, shift)) for each in finding.related)
    return finding._replace(place=_moved(finding.place, file, shift), related=related)


def _moved(place: Place, file: str, shift: int) -> Place:
    if place.file != file or place.line > 0:
        return place
    return place._replace(col=place.col + shift, end_col=place.end_col + (shift if place.end_line == 0 else 0))
