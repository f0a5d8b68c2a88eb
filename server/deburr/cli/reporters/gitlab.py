"""GitLab's code quality report: a JSON list of Code Climate issues, as far as GitLab reads them.

Source: GitLab, "Code Quality", "Import Code Quality results from a CI/CD job".
"""

from json import dumps
from typing import Any, TextIO

from deburr.cli.fingerprint import digest
from deburr.cli.forge import inside, top
from deburr.cli.result import Found, Result
from deburr.cli.style import Style
from deburr.finding import Severity

TEXT = False
KEYED = True
_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings."""
    folder = top()
    out.write(dumps([_issue(each, folder) for each in result.found], indent=2, ensure_ascii=False) + "\n")


def _issue(found: Found, folder: str) -> dict[str, Any]:
    finding, place = found.finding, found.finding.place
    path = inside(place.file, folder)
    return {
        "description": finding.message,
        "check_name": finding.rule,
        # GitLab knows an issue by this alone, so the file is part of it.
        "fingerprint": digest(path, found.fingerprint),
        "severity": _SEVERITIES[finding.severity],
        "location": {
            "path": path,
            "positions": {
                "begin": {"line": place.line + 1, "column": place.col + 1},
                "end": {"line": place.end_line + 1, "column": place.end_col + 1},
            },
        },
    }
