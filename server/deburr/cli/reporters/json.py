"""A JSON list of findings with 1-based rows and columns in code points; of a part of a check an object that holds it."""

from collections.abc import Iterable
from typing import Any, TextIO

from deburr.cli.result import Found, Result, Row
from deburr.cli.style import Style
from deburr.finding import Fix, Place

TEXT = False
KEYED = True


def report(result: Result, out: TextIO, style: Style) -> None:
    """Write the findings; of a part of a check within what the report says of itself."""
    found = [as_object(each) for each in result.found]
    part = part_as_object(result)
    _write(found if part is None else {**part, "findings": found}, out)


def statistics(rows: Iterable[Row], out: TextIO, style: Style) -> None:
    """Write how often each rule spoke."""
    _write([row_as_object(row) for row in rows], out)


def as_object(found: Found) -> dict[str, Any]:
    """A finding as the interface promises it. No site carries the pages, so ``url`` is null; `deburr rule NAME` prints them."""
    finding, place = found.finding, found.finding.place
    return {
        "filename": place.file,
        "dialect": found.dialect,
        "rule": finding.rule,
        "severity": finding.severity.word,
        "message": finding.message,
        **_ends(place),
        "url": None,
        "related": [
            {"filename": each.place.file, **_ends(each.place), "message": each.message, "entered": each.entered}
            for each in finding.related
        ],
        "fingerprint": found.fingerprint,
        "fix": None if finding.fix is None else _fix(finding.fix),
    }


def part_as_object(result: Result) -> dict[str, Any] | None:
    """Of a part of a check which one it is, how many programs it has, and which of them could not be checked; None of a whole check."""
    if result.shard is None:
        return None
    failed = [{"filename": each.file, "message": each.failure} for each in result.outcomes if each.failure]
    return {"shard": result.shard._asdict(), "programs": len(result.outcomes), "failed": failed}


def row_as_object(row: Row) -> dict[str, Any]:
    """A line of the statistics."""
    return {"rule": row.rule, "severity": row.severity.word, "count": row.times, "summary": row.summary}


def _fix(fix: Fix) -> dict[str, Any]:
    """What would be done: each edit puts ``content`` in place of what stands between two places."""
    edits = [{**_ends(Place("", *edit.start, *edit.end)), "content": edit.text} for edit in fix.edits]
    return {"message": fix.title, "applicability": fix.applicability, "edits": edits}


def _ends(place: Place) -> dict[str, Any]:
    return {
        "location": {"row": place.line + 1, "column": place.col + 1},
        "end_location": {"row": place.end_line + 1, "column": place.end_col + 1},
    }


def _write(objects: object, out: TextIO) -> None:
    from json import dumps

    out.write(dumps(objects, indent=2, ensure_ascii=False) + "\n")
