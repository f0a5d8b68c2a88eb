"""All outcomes of a check together: what is counted, what the last line says, what the exit code is."""

from collections import Counter
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from deburr.cli.run import Outcome
from deburr.finding import Finding, Place, Severity, joined


class Shard(NamedTuple):
    """One of several parts of the programs: its number from 1, and how many there are."""

    number: int
    of: int

    def __str__(self) -> str:
        return f"{self.number}/{self.of}"


class Row(NamedTuple):
    """A line of the statistics."""

    rule: str
    severity: Severity
    times: int
    summary: str


class Found(NamedTuple):
    """A finding with the dialect that it was found in, whether it makes the check fail, and its fingerprint ("" where none was asked for)."""

    finding: Finding
    dialect: str
    fails: bool
    fingerprint: str = ""


class Result:
    """The outcomes in the order of their files.

    ``known``: the findings that are passed over, by file and fingerprint. ``origin``: where outcomes come
    from that tell nothing of the programs in which nothing was found. ``shard``: of which part of a check they are, if not of all.
    """

    def __init__(
        self,
        outcomes: tuple[Outcome, ...],
        known: frozenset[tuple[str, str]] = frozenset(),
        origin: str = "",
        shard: Shard | None = None,
    ) -> None:
        self.outcomes = outcomes
        self.origin = origin
        self.shard = shard
        self._known = known

    @cached_property
    def everything(self) -> list[Found]:
        """All findings in order of file, row and column. What several programs find at a place of a file that they share is one finding."""
        first: dict[tuple[Place, str, str], Found] = {}
        keys: dict[tuple[Place, str, str], str] = {}
        for outcome in self.outcomes:
            for finding in outcome.findings:
                fails, known = finding.severity >= outcome.fail_on, first.get(finding.order)
                if known is not None:
                    finding, fails = joined(known.finding, finding), fails or known.fails
                first[finding.order] = Found(finding, outcome.dialect or "", fails)
            keys.update((each.order, key) for each, key in zip(outcome.findings, outcome.keys))
        ordered = sorted(first.values(), key=lambda each: each.finding.order)
        if not keys:
            return ordered
        from deburr.cli.fingerprint import counted

        marks = counted((each.finding.place.file, keys[each.finding.order]) for each in ordered)
        return [each._replace(fingerprint=mark) for each, mark in zip(ordered, marks)]

    @cached_property
    def found(self) -> list[Found]:
        """The findings that are reported."""
        known = self._known
        return [each for each in self.everything if (each.finding.place.file, each.fingerprint) not in known]

    def findings(self) -> Iterator[Finding]:
        """The findings that are reported, alone."""
        return (each.finding for each in self.found)

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

        counts = Counter((finding.rule, finding.severity) for finding in self.findings())
        dialects = {each.dialect for each in self.found}
        summaries = {rule.name: rule.summary for dialect in dialects for rule in rules_of(dialect)}
        rows = [Row(rule, severity, count, summaries[rule]) for (rule, severity), count in counts.items()]
        return sorted(rows, key=lambda row: (-row.times, row.rule))

    def summary(self) -> str:
        """The last line of reports for people: `Found 3 errors, 1 warning in 2 files (12 checked)`."""
        counts = Counter(finding.severity for finding in self.findings())
        failed = sum(1 for outcome in self.outcomes if outcome.failure)
        skipped = sum(1 for outcome in self.outcomes if outcome.dialect is None and not outcome.failure)
        checked = len(self.outcomes) - failed - skipped
        parts = [self.origin or f"{checked} checked", *([f"{failed} not checked"] if failed else [])]
        parts += [f"{skipped} skipped: no dialect"] if skipped else []
        fixed = sum(outcome.fixed for outcome in self.outcomes)
        parts += [f"{fixed} fixed"] if fixed else []
        hidden = len(self.everything) - len(self.found)
        parts += [f"{hidden} known before"] if hidden else []
        aside = f"({', '.join(parts)})"
        if not counts:
            return f"{'All checks passed' if checked and not failed else 'No findings'} {aside}"
        said = ", ".join(_count(counts[each], each.word) for each in reversed(Severity) if counts[each])
        files = len({finding.place.file for finding in self.findings()})
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
        return int(not exit_zero and any(each.fails for each in self.found))


def _count(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"
