"""Findings as the protocol's diagnostics, in JSON: hundreds of them are sent at each keystroke, so no objects are made for them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from functools import lru_cache
from hashlib import md5
from typing import TYPE_CHECKING, Any, NamedTuple

from deburr.finding import Finding, Place, Related, Severity
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


class _Kept(NamedTuple):
    """A finding as it was pushed, and the other files to which it points."""

    finding: Finding
    text: str
    files: tuple[str, ...]


class Written:
    """The diagnostics of one file as they were pushed last: a finding that still stands where it stood is not written once more."""

    def __init__(self) -> None:
        self._kept: dict[int, _Kept] = {}
        self._others: dict[str, object] = {}
        """The other files to which findings point, as they were then: of what stands in front of a place there, its units hang."""

    def capped(self, findings: Sequence[Finding], several: int, session: Session) -> str:
        """The first findings for the client, of ``several`` in all, as the text of a list; and how many more there are."""
        report = _Report(session)
        stale = {file for file, state in self._others.items() if session.state(file) != state}
        before, self._kept = self._kept, {}
        for finding in findings[:MOST]:
            kept = before.get(id(finding))
            # What stands before it on its line is as it was: whatever is typed there, or before what it points to, makes another finding of it.
            if kept is None or kept.finding is not finding or not stale.isdisjoint(kept.files):
                kept = _Kept(finding, report.text(finding), _elsewhere(finding))
            self._kept[id(finding)] = kept
        self._others = {
            file: session.state(file) for file in {file for kept in self._kept.values() for file in kept.files}
        }
        found = [kept.text for kept in self._kept.values()]
        if several > len(found) and found:
            last = report.range(findings[len(found) - 1].place)
            rest = f"{several - len(found)} more findings below"
            found.append(json.dumps({"range": last, "severity": 3, "source": "deburr", "message": rest}))
        return f"[{', '.join(found)}]"


def _elsewhere(finding: Finding) -> tuple[str, ...]:
    file = finding.place.file
    return tuple({each.place.file for each in finding.related if each.place.file != file}) if finding.related else ()


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
        self._uris: dict[str, str] = {}
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
        written = _written(finding.rule, finding.severity, finding.message, self._pages)
        if finding.related:
            related = ", ".join([self._pointing(each) for each in finding.related])
            written = f'{written.removesuffix("}")}, "relatedInformation": [{related}]}}'
        return f'{{"range": {self._range(finding.place)}, {written}'

    def range(self, place: Place) -> Json:
        """A place for the client."""
        start, end = self._ends(place)
        return {"start": dict(zip(_POSITION, start)), "end": dict(zip(_POSITION, end))}

    def _pointing(self, related: Related) -> str:
        file = related.place.file
        uri = self._uris.get(file)
        if uri is None:
            uri = self._uris[file] = json.dumps(self._session.uri(file))
        where = f'{{"uri": {uri}, "range": {self._range(related.place)}}}'
        return f'{{"location": {where}, "message": {_quoted(related.message)}}}'

    def _range(self, place: Place) -> str:
        (line, start), (end_line, end) = self._ends(place)
        return (
            f'{{"start": {{"line": {line}, "character": {start}}}, "end": {{"line": {end_line}, "character": {end}}}}}'
        )

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


@lru_cache(maxsize=2_048)
def _quoted(message: str) -> str:
    return json.dumps(message)
