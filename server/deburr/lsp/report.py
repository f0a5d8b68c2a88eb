"""Findings as the protocol's diagnostics, in JSON: hundreds of them are sent at each keystroke, so no objects are made for them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from functools import lru_cache
from hashlib import md5
from typing import TYPE_CHECKING, Any

from deburr.finding import Finding, Place, Severity
from deburr.lsp.capabilities import PAGES

if TYPE_CHECKING:
    from deburr.lsp.convert import Line
    from deburr.lsp.session import Session

MOST = 500
"""Diagnostics of one document that are pushed; a client that asks is given all."""


_NOWHERE = Place("", 0, 0, 0, 0)
_POSITION = ("line", "character")
_LEVELS = {Severity.ERROR: 1, Severity.WARNING: 2, Severity.INFO: 3}

Json = dict[str, Any]


def diagnostics(findings: Iterable[Finding], session: Session) -> list[Json]:
    """Findings for the client."""
    return list(_Report(session).all(findings))


class Written:
    """The diagnostics of one file as they were pushed last: a finding that still stands where it stood is not written once more."""

    def __init__(self) -> None:
        self._texts: dict[int, tuple[Finding, str]] = {}

    def capped(self, findings: Sequence[Finding], several: int, session: Session) -> str:
        """The first findings for the client, of ``several`` in all, as the text of a list; and how many more there are."""
        report = _Report(session)
        before, self._texts = self._texts, {}
        for finding in findings[:MOST]:
            kept = before.get(id(finding))
            # What stands before it on its line is as it was: whatever is typed there makes another finding of it.
            same = kept is not None and kept[0] is finding and not finding.related
            self._texts[id(finding)] = kept if kept and same else (finding, report.text(finding))
        found = [text for _, text in self._texts.values()]
        if several > len(found) and found:
            last = report.range(findings[len(found) - 1].place)
            rest = f"{several - len(found)} more findings below"
            found.append(json.dumps({"range": last, "severity": 3, "source": "deburr", "message": rest}))
        return f"[{', '.join(found)}]"


def result_id(items: Sequence[Json]) -> str:
    """A name for exactly these diagnostics."""
    return md5(json.dumps(items).encode(), usedforsecurity=False).hexdigest()


def page_uri(rule: str) -> str:
    """Where the manual page of a rule is read."""
    return f"{PAGES}:/{rule}.md"


class _Report:
    """Diagnostics of one moment; the lines of each file are found once."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._lines: dict[str, Line] = {}
        self._pages = session.client.content

    def all(self, findings: Iterable[Finding]) -> Iterable[Json]:
        """The diagnostics in order."""
        for finding in findings:
            found: Json = {"range": self.range(finding.place), **_said(finding, self._pages)}
            if finding.related:
                found["relatedInformation"] = [
                    {"location": self._location(each.place), "message": each.message} for each in finding.related
                ]
            yield found

    def text(self, finding: Finding) -> str:
        """A diagnostic as JSON: what it says is written once, for at each keystroke hundreds are sent of which none is another."""
        if finding.related:
            return json.dumps(next(iter(self.all((finding,)))))
        (line, start), (end_line, end) = self._ends(finding.place)
        ends = (
            f'{{"start": {{"line": {line}, "character": {start}}}, "end": {{"line": {end_line}, "character": {end}}}}}'
        )
        return f'{{"range": {ends}, {_written(finding.rule, finding.severity, finding.message, self._pages)}'

    def range(self, place: Place) -> Json:
        """A place for the client."""
        start, end = self._ends(place)
        return {"start": dict(zip(_POSITION, start)), "end": dict(zip(_POSITION, end))}

    def _location(self, place: Place) -> Json:
        return {"uri": self._session.uri(place.file), "range": self.range(place)}

    def _ends(self, place: Place) -> tuple[tuple[int, int], tuple[int, int]]:
        file, line, col, end_line, end_col = place
        lines = self._lines.get(file)
        if lines is None:
            lines = self._lines[file] = self._session.lines(file)
        to_units = self._session.units.col_to_units
        text = lines(line)
        end = text if end_line == line else lines(end_line)
        return (line, to_units(text, col)), (end_line, to_units(end, end_col))


def _said(finding: Finding, pages: bool) -> Json:
    """What a diagnostic says besides where."""
    found: Json = {
        "severity": _LEVELS[finding.severity],
        "code": finding.rule,
        "source": "deburr",
        "message": finding.message,
    }
    return found | {"codeDescription": {"href": page_uri(finding.rule)}} if pages else found


@lru_cache(maxsize=2_048)
def _written(rule: str, severity: Severity, message: str, pages: bool) -> str:
    return json.dumps(_said(Finding(rule, severity, message, _NOWHERE), pages)).removeprefix("{")
