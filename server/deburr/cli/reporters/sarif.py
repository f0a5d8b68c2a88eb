"""SARIF 2.1.0, the form of results that code scanning of forges reads. Source: OASIS, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0"."""

from collections.abc import Sequence
from json import dumps
from typing import Any, TextIO
from urllib.parse import quote

from deburr import __version__
from deburr.catalogue import rules_of
from deburr.cli.forge import inside, top
from deburr.cli.result import Found, Result
from deburr.cli.style import Style
from deburr.finding import Finding, Fix, Place, Related, Severity
from deburr.page import markdown, page_of
from deburr.rule import Rule
from deburr_grammar.dialects import by_name

TEXT = False
KEYED = True
SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
_TOP = "%SRCROOT%"
_MARK = "deburr/v1"
"""The name under which fingerprints stand; another way to make them has another."""
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings with the pages of their rules."""
    folder, found = top(), result.found
    named = sorted({(each.finding.rule, each.dialect) for each in found})
    known = {rule.name: rule for dialect in {dialect for _, dialect in named} for rule in rules_of(dialect)}
    order = {name: at for at, (name, _) in enumerate(named)}
    run = {
        "tool": {
            "driver": {
                "name": "deburr",
                "version": __version__,
                "semanticVersion": __version__,
                "rules": [_rule(known[name], dialect) for name, dialect in named],
            }
        },
        "columnKind": "unicodeCodePoints",
        "originalUriBaseIds": {_TOP: {"uri": f"{_absolute(folder.rstrip('/'))}/"}},
        "invocations": [_invocation(result, folder)],
        "results": [_result(each, order[each.finding.rule], folder) for each in found],
    }
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    out.write(dumps(log, indent=2, ensure_ascii=False) + "\n")


def _rule(rule: Rule, dialect: str) -> dict[str, Any]:
    language = by_name(dialect)
    page, text = page_of(rule, language), markdown(rule, language)
    return {
        "id": rule.name,
        "name": "".join(word.capitalize() for word in rule.short.split("-")),
        "shortDescription": {"text": page.summary},
        "fullDescription": {"text": page.why or page.summary},
        "help": {"text": text, "markdown": text},
        "defaultConfiguration": {"level": _LEVELS[rule.severity], "enabled": rule.default},
        "properties": {"tags": [dialect]},
    }


def _result(found: Found, index: int, folder: str) -> dict[str, Any]:
    finding = found.finding
    said: dict[str, Any] = {
        "ruleId": finding.rule,
        "ruleIndex": index,
        "level": _LEVELS[finding.severity],
        "message": {"text": finding.message},
        "locations": [_location(finding.place, folder)],
        "partialFingerprints": {_MARK: found.fingerprint},
    }
    entered = [each for each in finding.related if each.entered]
    others = [each for each in finding.related if not each.entered]
    if others:
        said["relatedLocations"] = [{"id": at, **_explained(each, folder)} for at, each in enumerate(others)]
    if entered:
        said["codeFlows"] = [_flow(finding, entered, folder)]
    if finding.fix is not None:
        said["fixes"] = [_fix(finding.fix, finding.place.file, folder)]
    return said


def _flow(finding: Finding, entered: Sequence[Related], folder: str) -> dict[str, Any]:
    """The calls and loop passes from the outermost inwards, and the finding's own place."""
    steps = [*(_explained(each, folder) for each in reversed(entered))]
    steps.append({**_location(finding.place, folder), "message": {"text": finding.message}})
    locations = [{"location": step, "nestingLevel": level} for level, step in enumerate(steps)]
    return {"threadFlows": [{"locations": locations}]}


def _fix(fix: Fix, file: str, folder: str) -> dict[str, Any]:
    """Other than in ours, "safe" has no place in SARIF: it stands in the description."""
    replacements = [
        {"deletedRegion": _region(Place(file, *edit.start, *edit.end)), "insertedContent": {"text": edit.text}}
        for edit in fix.edits
    ]
    change = {"artifactLocation": _artifact(file, folder), "replacements": replacements}
    return {"description": {"text": f"{fix.title} ({fix.applicability})"}, "artifactChanges": [change]}


def _invocation(result: Result, folder: str) -> dict[str, Any]:
    """Whether all was checked, and what was not."""
    failed = [
        {
            "level": "error",
            "message": {"text": outcome.failure},
            "locations": [{"physicalLocation": {"artifactLocation": _artifact(outcome.file, folder)}}],
        }
        for outcome in result.outcomes
        if outcome.failure
    ]
    return {"executionSuccessful": not failed, **({"toolExecutionNotifications": failed} if failed else {})}


def _explained(related: Related, folder: str) -> dict[str, Any]:
    return {**_location(related.place, folder), "message": {"text": related.message}}


def _location(place: Place, folder: str) -> dict[str, Any]:
    return {"physicalLocation": {"artifactLocation": _artifact(place.file, folder), "region": _region(place)}}


def _artifact(file: str, folder: str) -> dict[str, Any]:
    path = inside(file, folder)
    return {"uri": _absolute(file)} if path == file else {"uri": quote(path), "uriBaseId": _TOP}


def _absolute(path: str) -> str:
    # A drive's letter is behind a third slash, too.
    return f"file://{'' if path[:1] in ('/', '') else '/'}{quote(path, safe='/:')}"


def _region(place: Place) -> dict[str, int]:
    """1-based, in code points, the end column excluded."""
    return {
        "startLine": place.line + 1,
        "startColumn": place.col + 1,
        "endLine": place.end_line + 1,
        "endColumn": place.end_col + 1,
    }
