"""Findings as the protocol's diagnostics, in JSON: hundreds of them are sent at each keystroke, so no objects are made for them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from hashlib import md5
from typing import TYPE_CHECKING, Any

from deburr.finding import Severity
from deburr.lsp.capabilities import PAGES

if TYPE_CHECKING:
    from deburr.finding import Finding, Place
    from deburr.lsp.convert import Line
    from deburr.lsp.session import Session

MOST = 500
"""Diagnostics of one document that are pushed; a client that asks is given all."""


_LEVELS = {Severity.ERROR: 1, Severity.WARNING: 2, Severity.INFO: 3}

Json = dict[str, Any]


def diagnostics(findings: Iterable[Finding], session: Session) -> list[Json]:
    """Findings for the client."""
    return list(_Report(session).all(findings))


def capped(findings: Sequence[Finding], session: Session) -> list[Json]:
    """The first findings for the client, and how many more there are."""
    found = diagnostics(findings[:MOST], session)
    if len(findings) > MOST:
        rest = len(findings) - MOST
        last = found[-1]["range"]
        found.append({"range": last, "severity": 3, "source": "deburr", "message": f"{rest} more findings below"})
    return found


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

    def all(self, findings: Iterable[Finding]) -> Iterable[Json]:
        """The diagnostics in order."""
        pages = self._session.client.content
        for finding in findings:
            found: Json = {
                "range": self._range(finding.place),
                "severity": _LEVELS[finding.severity],
                "code": finding.rule,
                "source": "deburr",
                "message": finding.message,
            }
            if pages:
                found["codeDescription"] = {"href": page_uri(finding.rule)}
            if finding.related:
                found["relatedInformation"] = [
                    {"location": self._location(each.place), "message": each.message} for each in finding.related
                ]
            yield found

    def _location(self, place: Place) -> Json:
        return {"uri": self._session.uri(place.file), "range": self._range(place)}

    def _range(self, place: Place) -> Json:
        lines = self._lines.get(place.file)
        if lines is None:
            lines = self._lines[place.file] = self._session.lines(place.file)
        return {"start": self._at(lines, place.line, place.col), "end": self._at(lines, place.end_line, place.end_col)}

    def _at(self, lines: Callable[[int], str], line: int, col: int) -> Json:
        return {"line": line, "character": self._session.units.col_to_units(lines(line), col)}
