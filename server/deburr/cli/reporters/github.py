"""Annotations of GitHub Actions: a workflow command for each finding, which the runner shows on its line.

Source: GitHub, "Workflow commands for GitHub Actions", and `escapeData` and `escapeProperty` of `@actions/core`.
"""

from typing import TextIO

from deburr.cli.forge import inside, top
from deburr.cli.result import Result
from deburr.cli.style import Style, plain
from deburr.finding import Finding, Severity

TEXT = False
_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings, and as errors without a place what could not be checked."""
    folder = top()
    for outcome in result.outcomes:
        if outcome.failure:
            name = _property(inside(outcome.file, folder))
            out.write(f"::error title=deburr,file={name}::{_data(plain(outcome.failure))}\n")
    for finding in result.findings():
        out.write(f"{_command(finding, folder)}\n")


def _command(finding: Finding, folder: str) -> str:
    place = finding.place
    said = {"title": f"deburr ({finding.rule})", "file": inside(place.file, folder), "line": place.line + 1}
    said["endLine"] = place.end_line + 1
    if place.line == place.end_line:
        # Columns of a place that goes over several lines are refused.
        said |= {"col": place.col + 1, "endColumn": place.end_col + 1}
    shown = ",".join(f"{name}={_property(str(value))}" for name, value in said.items())
    others = (
        f"{inside(each.place.file, folder)}:{each.place.line + 1}:{each.place.col + 1}: {each.message}"
        for each in finding.related
    )
    message = "\n".join(map(plain, (finding.message, *others)))
    return f"::{_COMMANDS[finding.severity]} {shown}::{_data(message)}"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
