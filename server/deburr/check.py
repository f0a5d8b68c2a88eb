"""A program's bytes to its findings, in places of the file. Never opens a file, never chooses a dialect."""

from deburr.analysis import Analysis
from deburr.finding import Finding, Place
from deburr.host import Host
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document


def check(
    source: Source, dialect: Dialect, ruleset: RuleSet, file: str = "", host: Host | None = None
) -> list[Finding]:
    """All findings in order."""
    document = Document.parse(source.text, dialect)
    findings = Analysis(document, ruleset, file, host, tuple(source.notices())).findings()
    return [_in_file(finding, file, source.shift) for finding in findings] if source.shift else findings


def _in_file(finding: Finding, file: str, shift: int) -> Finding:
    """The finding where an editor shows it: what leads the program moves its first line."""
    related = tuple(each._replace(place=_moved(each.place, file, shift)) for each in finding.related)
    return finding._replace(place=_moved(finding.place, file, shift), related=related)


def _moved(place: Place, file: str, shift: int) -> Place:
    if place.file != file or place.line > 0:
        return place
    return place._replace(col=place.col + shift, end_col=place.end_col + (shift if place.end_line == 0 else 0))
