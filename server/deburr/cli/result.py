"""All outcomes of a check together: what is counted, what the last line says, what the exit code is."""

from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from deburr.cli.run import Outcome
from deburr.finding import Finding, Severity


class Row(NamedTuple):
    """A line of the statistics."""

    rule: str
    severity: Severity
    times: int
    summary: str


class Result:
    """The outcomes in the order of their files."""

    def __init__(self, outcomes: tuple[Outcome, ...]) -> None:
        self.outcomes = outcomes

    def findings(self) -> Iterator[tuple[Finding, str]]:
        """All findings in order of file, row and column, each with the dialect that it was found in.

        What several programs find in a file that they share is one finding.
        """
        shared = set[Finding]()
        for outcome in self.outcomes:
            for finding in outcome.findings:
                if finding.place.file != outcome.file:
                    if finding in shared:
                        continue
                    shared.add(finding)
                yield finding, outcome.dialect or ""

    @cached_property
    def texts(self) -> dict[tuple[str, int], str]:
        """The lines that reports show, by file and line."""
        return {place: text for outcome in self.outcomes for place, text in outcome.texts}

    @property
    def misgiven(self) -> str:
        """What is wrong with a value that was given for the runs; nothing if it may be meant for another of the languages."""
        wrong = next((outcome for outcome in self.outcomes if outcome.misgiven), None)
        others = {outcome.dialect for outcome in self.outcomes if wrong is not None and outcome.dialect}
        return wrong.misgiven if wrong is not None and others == {wrong.dialect} else ""

    def statistics(self) -> list[Row]:
        """How often each rule spoke: the most frequent first."""
        from deburr.catalogue import rules_of

        counts = Counter((finding.rule, finding.severity) for finding, _ in self.findings())
        dialects = {dialect for _, dialect in self.findings()}
        summaries = {rule.name: rule.summary for dialect in dialects for rule in rules_of(dialect)}
        rows = [Row(rule, severity, count, summaries[rule]) for (rule, severity), count in counts.items()]
        return sorted(rows, key=lambda row: (-row.times, row.rule))

    def summary(self) -> str:
        """The last line of reports for people: `Found 3 errors, 1 warning in 2 files (12 checked)`."""
        counts = Counter(finding.severity for finding, _ in self.findings())
        failed = sum(1 for outcome in self.outcomes if outcome.failure)
        skipped = sum(1 for outcome in self.outcomes if outcome.dialect is None and not outcome.failure)
        checked = len(self.outcomes) - failed - skipped
        parts = [f"{checked} checked", *([f"{failed} not checked"] if failed else [])]
        parts += [f"{skipped} skipped: no dialect"] if skipped else []
        fixed = sum(outcome.fixed for outcome in self.outcomes)
        parts += [f"{fixed} fixed"] if fixed else []
        aside = f"({', '.join(parts)})"
        if not counts:
            return f"{'All checks passed' if checked and not failed else 'No findings'} {aside}"
        said = ", ".join(_count(counts[each], each.word) for each in reversed(Severity) if counts[each])
        files = len({finding.place.file for finding, _ in self.findings()})
        return f"Found {said} in {_count(files, 'file')} {aside}"

    def would_fix(self) -> str:
        """The last line where fixes are only shown."""
        changed = [outcome for outcome in self.outcomes if outcome.change]
        if not changed:
            return "Nothing to fix"
        count = sum(outcome.fixed for outcome in changed)
        return f"Would fix {_count(count, 'finding')} in {_count(len(changed), 'file')}"

    def code(self, exit_zero: bool) -> int:
        """The exit code: 2 where a file could not be checked, 1 where findings count, else 0."""
        if any(outcome.failure for outcome in self.outcomes):
            return 2
        return int(not exit_zero and any(outcome.fails for outcome in self.outcomes))


def _count(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"
