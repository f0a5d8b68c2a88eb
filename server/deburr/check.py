"""A program's bytes to its findings, in places of the file. Never opens a file, never chooses a dialect."""

from collections.abc import Callable, Iterable

from deburr.analysis import Analysis
from deburr.finding import Finding, Fix, Place
from deburr.host import Host, NoFiles
from deburr.inputs import Inputs
from deburr.ruleset import RuleSet
from deburr.source import Source
from deburr.values import proving
from deburr_grammar.dialect import Dialect
from deburr_grammar.document import Document
from deburr_grammar.text import Edit, Pos


def check(
    source: Source,
    dialect: Dialect,
    ruleset: RuleSet,
    file: str = "",
    host: Host | None = None,
    run: Callable[[Analysis], Iterable[Finding | None]] | None = None,
    inputs: Inputs | None = None,
    *,
    mend: bool = False,
) -> list[Finding]:
    """All findings in order; with ``run`` (`deburr.ran`) also those that a run of the program meets, with ``mend`` each with what would mend it."""
    document = opened(source, dialect, ruleset, host)
    analysis = Analysis(document, ruleset, file, host, tuple(source.notices()), run, inputs, proving)
    findings = analysis.findings()
    if mend and findings:
        # Only what is wrong pays for what mends it.
        from deburr.fix import with_fixes

        findings = list(with_fixes(analysis, findings))
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
    fix = None if finding.fix is None else _fix_in_file(finding.fix, shift)
    return finding._replace(place=_moved(finding.place, file, shift), related=related, fix=fix)


def _fix_in_file(fix: Fix, shift: int) -> Fix:
    ends = [[Pos(at.line, at.col + (0 if at.line else shift)) for at in edit[:2]] for edit in fix.edits]
    return fix._replace(edits=tuple(Edit(start, end, edit.text) for edit, (start, end) in zip(fix.edits, ends)))


def _moved(place: Place, file: str, shift: int) -> Place:
    if place.file != file or place.line > 0:
        return place
    return place._replace(col=place.col + shift, end_col=place.end_col + (shift if place.end_line == 0 else 0))
